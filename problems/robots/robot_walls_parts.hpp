// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>

// What the sources of RobotWalls share.

namespace leastcost {
namespace robot_walls {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();
inline constexpr double kOfLengths =
    256 * std::numeric_limits<double>::epsilon();  ///< rounding of frames and distances
inline constexpr double kOfScene =
    16 * std::numeric_limits<double>::epsilon();  ///< the same of one distance from an obstacle, by its coordinates
inline constexpr double kDecided = 1e-10;         ///< sizes: so near are the bounds of a clearance in contact
inline constexpr double kShareOfGap = 0.5;

/// Whether the distance of two boxes with sides along the axes is more than this.
inline bool farther_apart(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper,
                          const Eigen::Vector3d& other_lower, const Eigen::Vector3d& other_upper, double distance) {
  double square = 0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double apart = std::max({other_lower[i] - upper[i], lower[i] - other_upper[i], 0.0});
    square += apart * apart;
  }
  return distance < 0 || square > distance * distance;
}

}  // namespace robot_walls

}  // namespace leastcost
