// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/space_bisector.hpp"

#include <algorithm>
#include <cmath>

namespace leastcost::bracket {
namespace {

using Eigen::Vector3d;

/// Index among the 27 values around a node.
std::size_t offset_of(const Eigen::Vector3i& d) { return static_cast<std::size_t>(13 + d[0] + 3 * d[1] + 9 * d[2]); }

/// Slope and second derivatives at a node by central differences.
Vector3d slope_around(const CubeNet& f, double h) {
  return Vector3d(f[14] - f[12], f[16] - f[10], f[22] - f[4]) / (2 * h);
}
Eigen::Matrix3d bend_around(const CubeNet& f, double h) {
  Eigen::Matrix3d bend;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const Eigen::Vector3i x = Eigen::Vector3i::Unit(a), y = Eigen::Vector3i::Unit(b);
      bend(a, b) = a == b
                       ? f[offset_of(x)] - 2 * f[13] + f[offset_of(-x)]
                       : (f[offset_of(x + y)] - f[offset_of(x - y)] - f[offset_of(y - x)] + f[offset_of(-x - y)]) / 4;
    }
  return bend / (h * h);
}

/// The signed cost from a node to the bisector, f the difference of the fields: the distance by one step of Halley
/// along the gradient, times the density in its middle.
double cost_to_bisector(const CubeNet& f, const CubeNet& density, double h) {
  const Vector3d slope = slope_around(f, h);
  const double size = slope.norm() + 1e-12;
  const Vector3d along = slope / size;
  const double first = f[13] / size, bend = along.dot(bend_around(f, h) * along);
  const double distance = first + 0.5 * bend / size * first * first, n = density[13];
  if (!(std::abs(distance) < 1.85 * h) || distance * f[13] < 0)  // half a diagonal of 8 cells is 1.74 h
    return std::copysign(std::min(1.74 * h, std::abs(f[13]) / n), f[13]) * n;
  const double rise = slope_around(density, h).dot(along);
  return distance * (n - (std::isfinite(rise) ? 0.5 * rise * distance : 0));
}

}  // namespace

SpaceFront front_at_bisector(const SpaceLevel& level, const std::vector<double>& from_s,
                             const std::vector<double>& from_t) {
  SpaceFront front;
  front.density = level.density;
  front.values.assign(from_s.size(), kInfinity);
  front.sign.assign(from_s.size(), 1);
  std::vector<double> half(from_s.size());
  for (std::size_t node = 0; node < half.size(); ++node) {
    half[node] = 0.5 * (from_s[node] - from_t[node]);  // NaN where neither goes
    if (half[node] < 0) front.sign[node] = -1;
  }
  for (int node = 0; node < level.nodes.none(); ++node) {
    const auto at = static_cast<std::size_t>(node);
    if (!std::isfinite(half[at])) continue;
    bool beside = false, inner = level.nodes.is_inner(node);
    CubeNet values;
    if (inner) {
      values = around(level.nodes, half, node);
      for (const double value : values) beside = beside || (std::isfinite(value) && (value < 0) != (half[at] < 0));
    }
    if (!beside) continue;
    const double cost = cost_to_bisector(values, around(level.nodes, level.density, node), level.grid.h);
    if (!std::isfinite(cost)) continue;
    front.values[at] = std::abs(cost);
    front.seeds.push_back(node);
  }
  return front;
}

}  // namespace leastcost::bracket
