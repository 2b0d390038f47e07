// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace leastcost {

/// The point of a triangle in space that is nearest to x, exact to rounding; of a degenerate one, the nearest of the
/// segment or point that it is.
inline Eigen::Vector3d foot_on_triangle(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3d& x) {
  const Eigen::Vector3d u = corners[1] - corners[0], v = corners[2] - corners[0], w = x - corners[0];
  const Eigen::Vector3d normal = u.cross(v);
  const double area = normal.squaredNorm();
  if (area > 0) {
    const double of_u = w.cross(v).dot(normal) / area, of_v = u.cross(w).dot(normal) / area;
    if (of_u >= 0 && of_v >= 0 && of_u + of_v <= 1) return corners[0] + of_u * u + of_v * v;
  }
  Eigen::Vector3d best = corners[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d &from = corners[k], side = corners[(k + 1) % 3] - from;
    const double square = side.squaredNorm();
    const double t = square > 0 ? std::clamp((x - from).dot(side) / square, 0.0, 1.0) : 0;
    const Eigen::Vector3d foot = from + t * side;
    if ((foot - x).squaredNorm() < (best - x).squaredNorm()) best = foot;
  }
  return best;
}

}  // namespace leastcost
