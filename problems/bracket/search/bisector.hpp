// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "problems/bracket/search/level.hpp"

namespace leastcost::bracket {

/// A function of the nodes around one, by central differences.
template <int N>
struct LocalField {
  double value;
  Vector<N> slope;
  Eigen::Matrix<double, N, N> bend;

  LocalField(const Net<N>& f, double h) : value(f[kNetMiddle<N>]), slope(slope_of(f, h)) {
    constexpr std::size_t here = kNetMiddle<N>;
    for (int a = 0; a < N; ++a)
      for (int b = 0; b < N; ++b) {
        const std::size_t x = kNetStep[static_cast<std::size_t>(a)], y = kNetStep[static_cast<std::size_t>(b)];
        bend(a, b) = a == b ? f[here + x] - 2 * f[here] + f[here - x]
                            : (f[here + x + y] - f[here + x - y] - f[here + y - x] + f[here - x - y]) / 4;
      }
    bend /= h * h;
  }
  /// Of the slope, and the second derivative along a direction.
  double steepness() const { return N == 2 ? std::hypot(slope[0], slope[1]) : slope.norm(); }
  double bend_along(const Vector<N>& d) const {
    double sum = 0;
    for (int a = 0; a < N; ++a)
      for (int b = a; b < N; ++b) sum += (a == b ? 1 : 2) * d[a] * d[b] * bend(a, b);
    return sum;
  }
  static Vector<N> slope_of(const Net<N>& f, double h) {
    Vector<N> out;
    for (int k = 0; k < N; ++k) {
      const std::size_t step = kNetStep[static_cast<std::size_t>(k)];
      out[k] = f[kNetMiddle<N> + step] - f[kNetMiddle<N> - step];
    }
    return out / (2 * h);
  }
};

/// The signed cost from a node to the bisector, f half the difference of the fields: the distance by one step of Halley
/// along the gradient, times the density in its middle.
template <int N>
double cost_to_bisector(const Net<N>& f, const Net<N>& density, double h) {
  // Half a diagonal of 2^N cells, and a little more.
  constexpr double kHalfDiagonal = N == 2 ? 1.42 : 1.74, kFarther = N == 2 ? 1.5 : 1.85;
  const LocalField<N> field(f, h);
  const double size = field.steepness() + 1e-12, n = density[kNetMiddle<N>];
  const Vector<N> along = field.slope / size;
  const double first = field.value / size, bend = field.bend_along(along);
  const double distance = first + 0.5 * bend / size * first * first;
  if (!(std::abs(distance) < kFarther * h) || distance * field.value < 0)
    return std::copysign(std::min(kHalfDiagonal * h, std::abs(field.value) / n), field.value) * n;
  const double rise = LocalField<N>::slope_of(density, h).dot(along);
  return distance * (n - (std::isfinite(rise) ? 0.5 * rise * distance : 0));
}

/// The same where the cost depends on the direction: u = a f (1 - f (dH/dp . grad a) / 2), a = 1 / H(x, grad f), has
/// H(x, grad u) = 1 up to the square of f.
template <Medium M>
double directed_cost_to_bisector(const std::vector<double>& half, const Level<M>& level, int node) {
  constexpr int N = M::kDimension;
  const double h = level.grid.h;
  const auto slope = [&](int at) -> Vector<N> { return LocalField<N>::slope_of(around(level.nodes, half, at), h); };
  const auto factor = [&](int at) { return 1 / level.known.size(at, slope(at), false); };
  const double f = half[static_cast<std::size_t>(node)], a = factor(node);
  const auto beside = level.nodes.beside(node);
  if (!std::ranges::all_of(beside, [&](int other) { return level.nodes.is_inner(other); })) return a * f;
  const Vector<N> v = level.known.steepest(node, slope(node));
  double rise = 0;
  for (int k = 0; k < N; ++k) {
    const auto axis = 2 * static_cast<std::size_t>(k);
    rise += v[k] * (factor(beside[axis + 1]) - factor(beside[axis]));
  }
  rise /= 2 * h;
  constexpr double kMost = 0.5;  // beyond is a shock
  return std::abs(f * rise) < kMost ? a * f * (1 - 0.5 * f * rise) : a * f;
}

/// A front from the places that are as far from one end as from the other: the signed cost to them is a potential
/// without a singularity at the ends, negative on the side of the source. `from_s`, `from_t`: distance fields.
template <Medium M>
Front front_at_bisector(const Level<M>& level, const std::vector<double>& from_s, const std::vector<double>& from_t) {
  constexpr int N = M::kDimension;
  Front front;
  front.density = level.density;
  front.values.assign(from_s.size(), kInfinity);
  front.sign.assign(from_s.size(), 1);
  std::vector<double> half(from_s.size());
  for (std::size_t node = 0; node < half.size(); ++node) {
    half[node] = 0.5 * (from_s[node] - from_t[node]);  // NaN where neither goes
    if (half[node] < 0) front.sign[node] = -1;
  }
  for (int node = 0; node < level.nodes.none(); ++node) {
    const double here = half[static_cast<std::size_t>(node)];
    if (!std::isfinite(here) || !level.nodes.is_inner(node)) continue;
    const Net<N> values = around(level.nodes, half, node);
    if (std::ranges::none_of(values, [&](double f) { return std::isfinite(f) && (f < 0) != (here < 0); })) continue;
    double cost = 0;
    if constexpr (M::kIsotropic)
      cost = cost_to_bisector<N>(values, around(level.nodes, level.density, node), level.grid.h);
    else
      cost = directed_cost_to_bisector(half, level, node);
    if (!std::isfinite(cost)) continue;
    front.values[static_cast<std::size_t>(node)] = std::abs(cost);
    front.seeds.push_back(node);
  }
  return front;
}

}  // namespace leastcost::bracket
