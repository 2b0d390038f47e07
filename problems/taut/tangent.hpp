// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>

namespace leastcost {

/// A straight move from circle to circle.
struct Tangent {
  Eigen::Vector2d from, to;
};

/// Touches both circles; a radius is positive where the disc is on the left, negative where it is on the right, 0 for a
/// point. With n to its left, n . (b - a) = rb - ra. Nothing where one disc lies within the other, or two overlap that
/// it should pass between, by more than `within`.
inline std::optional<Tangent> tangent(const Eigen::Vector2d& a, double ra, const Eigen::Vector2d& b, double rb,
                                      double within) {
  const Eigen::Vector2d way = b - a;
  const double across = rb - ra, distance = way.norm();
  if (!(distance > 0) || std::abs(across) > distance + within) return std::nullopt;
  const double along = std::sqrt(std::max(0.0, distance * distance - across * across));
  const Eigen::Vector2d unit = way / distance, left(-unit.y(), unit.x());
  const Eigen::Vector2d n = (across * unit + along * left) / distance;
  return Tangent{a - ra * n, b - rb * n};
}

/// From one direction to another, counterclockwise: above -pi, at most pi.
inline double turn_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

}  // namespace leastcost
