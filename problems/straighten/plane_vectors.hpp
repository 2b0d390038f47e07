// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace leastcost {

/// Twice the signed area of the triangle 0, a, b: positive when b is to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// From 0 to pi.
inline double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(std::abs(cross(a, b)), a.dot(b));
}

}  // namespace leastcost
