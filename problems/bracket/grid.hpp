// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace leastcost::bracket {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEps = std::numeric_limits<double>::epsilon();

/// The larger of both; NaN, of which nothing is known, where one of them is.
inline double larger_or_nan(double a, double b) { return a >= b || a != a ? a : b; }

template <int N>
using Vector = Eigen::Matrix<double, N, 1>;
template <int N>
using Box = Eigen::AlignedBox<double, N>;
/// Points of a polyline, side by side.
template <int N>
using Way = Eigen::Matrix<double, N, Eigen::Dynamic>;
/// Number of a cell of a Grid along each axis.
template <int N>
using Place = std::array<int, static_cast<std::size_t>(N)>;

/// Calls f with count^N equal parts of a box, as long as it says true; whether it always did. Corners are computed
/// alike for the parts on both sides.
template <int N, class F>
bool for_parts_of(const Box<N>& box, int count, const F& f) {
  int all = 1;
  for (int k = 0; k < N; ++k) all *= count;
  for (int number = 0; number < all; ++number) {
    Box<N> part;
    for (int k = 0, rest = number; k < N; ++k, rest /= count) {
      const auto at = [&](int i) { return i == count ? box.max()[k] : box.min()[k] + box.sizes()[k] * i / count; };
      part.min()[k] = at(rest % count);
      part.max()[k] = at(rest % count + 1);
    }
    if (!f(part)) return false;
  }
  return true;
}

/// Square cells, or cubes, that tile a box and perhaps a little more, numbered from 1 to cells[k] along axis k; a layer
/// of cells lies around them. A node is the centre of a cell. By definition cell i reaches from corner + (i - 1) h to
/// corner + i h, without rounding.
template <int N>
struct Grid {
  Vector<N> corner = Vector<N>::Zero();
  double h = 1;
  Place<N> cells = {};
  Box<N> box;

  /// `count` cells along the longest side of the box.
  static Grid over(const Box<N>& box, int count) {
    // A box of whole numbers of cells is covered by these: in space by cells that are larger than needed by rounding.
    constexpr double kWider = N == 2 ? 1 : 1 + 1e-13, kMore = N == 2 ? 1 - 1e-12 : 1 + 1e-15;
    const Vector<N> size = box.sizes();
    Grid g{box.min(), size.maxCoeff() / count * kWider, {}, box};
    for (int k = 0; k < N; ++k) g.cells[at(k)] = static_cast<int>(std::ceil(size[k] / g.h * kMore));
    return g;
  }
  /// Every cell in `parts`^N, a power of two, so that the sides are halved without rounding.
  Grid refined(int parts) const {
    Grid g{corner, h / parts, cells, box};
    for (int& count : g.cells) count *= parts;
    return g;
  }

  int longest() const { return *std::max_element(cells.begin(), cells.end()); }
  double coordinate(int axis, int i) const { return corner[axis] + (i - 0.5) * h; }
  Vector<N> node(const Place<N>& p) const {
    Vector<N> x;
    for (int k = 0; k < N; ++k) x[k] = coordinate(k, p[at(k)]);
    return x;
  }
  bool is_cell(const Place<N>& p) const {
    for (std::size_t k = 0; k < p.size(); ++k)
      if (p[k] < 1 || p[k] > cells[k]) return false;
    return true;
  }
  Place<N> place_at(const Vector<N>& x) const {
    Place<N> p;
    for (int k = 0; k < N; ++k)
      p[at(k)] = std::clamp(static_cast<int>(std::floor((x[k] - corner[k]) / h)) + 1, 1, cells[at(k)]);
    return p;
  }
  Vector<N> in_box(const Vector<N>& p) const { return p.cwiseMax(box.min()).cwiseMin(box.max()); }

  /// What places of the grid are off by rounding, generously.
  double slack() const {
    int sum = 0;
    for (const int count : cells) sum += count;
    return 1e-15 * (corner.cwiseAbs().sum() + h * sum);
  }
  /// Of a cell, rounded up, and what the places of its corners are off: a ball around its node holds the cell.
  double half_diagonal() const { return (N == 2 ? 0.70711 : 0.8660255 * (1 + 1e-9)) * h + 16 * slack(); }

  /// The part in the box of the cube of side 2 `half` cells around a place in units of cells, rounded outward; empty
  /// where it lies outside.
  Box<N> cube(const Vector<N>& middle, double half) const {
    const Vector<N> c = corner + (middle.array() - 0.5).matrix() * h, r = Vector<N>::Constant(half * h + slack());
    return Box<N>(c - r, c + r).intersection(box);
  }
  /// The same of (2 reach + 1)^N cells around one.
  Box<N> cell(const Place<N>& p, double reach = 0) const {
    return cube(Eigen::Map<const Eigen::Matrix<int, N, 1>>(p.data()).template cast<double>(), 0.5 + reach);
  }

 private:
  static constexpr std::size_t at(int k) { return static_cast<std::size_t>(k); }
};

}  // namespace leastcost::bracket
