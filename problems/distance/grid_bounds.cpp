// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/grid_bounds.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

using Eigen::Matrix4d;

/// Of a cell: control points or coefficients, x fastest.
using Cell = std::array<double, 64>;

std::size_t place(int i, int j, int k) { return static_cast<std::size_t>((k * 4 + j) * 4 + i); }

/// Applies a matrix along an axis, 0 for x.
Cell along(const Matrix4d& m, int axis, const Cell& in) {
  Cell out{};
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b)
      for (int to = 0; to < 4; ++to) {
        const auto at = [&](int c) { return axis == 0 ? place(c, a, b) : axis == 1 ? place(a, c, b) : place(a, b, c); };
        double sum = 0;
        for (int from = 0; from < 4; ++from) sum += m(to, from) * in[at(from)];
        out[at(to)] = sum;
      }
  return out;
}

/// From four B-spline coefficients to the control points of the piece between the middle two.
const Matrix4d kToBezier = (Matrix4d() << 1, 4, 1, 0, 0, 4, 2, 0, 0, 2, 4, 0, 0, 1, 4, 1).finished() / 6;
/// Of a cubic to its derivative by the cell's length, quadratic, written as a cubic again (control points raised).
const Matrix4d kDerivative =
    (Matrix4d() << 1, 0, 0, 0, 1.0 / 3, 2.0 / 3, 0, 0, 0, 2.0 / 3, 1.0 / 3, 0, 0, 0, 1, 0).finished() *
    (Matrix4d() << -3, 3, 0, 0, 0, -3, 3, 0, 0, 0, -3, 3, 0, 0, 0, 0).finished();

Cell control_points(const Cell& coefficients) {
  return along(kToBezier, 2, along(kToBezier, 1, along(kToBezier, 0, coefficients)));
}

/// No eigenvalue of a symmetric matrix is above this: their mean and what their spread allows.
double most_upwards(double xx, double yy, double zz, double xy, double xz, double yz) {
  const double mean = (xx + yy + zz) / 3;
  const double spread = (xx - mean) * (xx - mean) + (yy - mean) * (yy - mean) + (zz - mean) * (zz - mean) +
                        2 * (xy * xy + xz * xz + yz * yz);
  return mean + std::sqrt(2.0 / 3 * spread);
}

template <class Visit>
void for_each_cell(const DistanceGrid& grid, const Visit& visit) {
  const auto& n = grid.shape().count;
  for (int k = 0; k + 1 < n[2]; ++k)
    for (int j = 0; j + 1 < n[1]; ++j)
      for (int i = 0; i + 1 < n[0]; ++i) visit(i, j, k);
}

}  // namespace

GridBounds bounds_above(const DistanceGrid& grid, double from) {
  GridBounds bounds;
  const double cell = grid.shape().cell;
  for_each_cell(grid, [&](int i, int j, int k) {
    const Cell values = control_points(grid.coefficients_of_cell(i, j, k));
    if (!(*std::max_element(values.begin(), values.end()) > from)) return;
    const std::array<Cell, 3> slope = {along(kDerivative, 0, values), along(kDerivative, 1, values),
                                       along(kDerivative, 2, values)};
    const Cell xx = along(kDerivative, 0, slope[0]), yy = along(kDerivative, 1, slope[1]),
               zz = along(kDerivative, 2, slope[2]), xy = along(kDerivative, 1, slope[0]),
               xz = along(kDerivative, 2, slope[0]), yz = along(kDerivative, 2, slope[1]);
    for (std::size_t c = 0; c < values.size(); ++c) {
      bounds.slope = std::max(bounds.slope, std::hypot(slope[0][c], slope[1][c], slope[2][c]) / cell);
      bounds.bend = std::max(bounds.bend, most_upwards(xx[c], yy[c], zz[c], xy[c], xz[c], yz[c]) / (cell * cell));
    }
  });
  return bounds;
}

double least_on_border(const DistanceGrid& grid) {
  const auto& n = grid.shape().count;
  double least = std::numeric_limits<double>::infinity();
  for_each_cell(grid, [&](int i, int j, int k) {
    const std::array<int, 3> cell = {i, j, k};
    std::array<std::array<bool, 2>, 3> sides{};
    bool any = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sides[axis] = {cell[axis] == 0, cell[axis] + 2 == n[axis]};
      any = any || sides[axis][0] || sides[axis][1];
    }
    if (!any) return;
    const Cell values = control_points(grid.coefficients_of_cell(i, j, k));
    for (int c = 0; c < 4; ++c)
      for (int b = 0; b < 4; ++b)
        for (int a = 0; a < 4; ++a) {
          const std::array<int, 3> at = {a, b, c};
          bool on_side = false;
          for (std::size_t axis = 0; axis < 3; ++axis)
            on_side = on_side || (sides[axis][0] && at[axis] == 0) || (sides[axis][1] && at[axis] == 3);
          if (on_side) least = std::min(least, values[place(a, b, c)]);
        }
  });
  return least;
}

}  // namespace leastcost
