// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace leastcost {

/// How far a straight move stays from the obstacles of a domain: the least distance over all of its points, minus the
/// distance that is required; length units. Negative: the move touches.
struct MoveClearance {
  double lower = 0;            ///< a bound, rounding included
  double upper = 0;            ///< attained at `place`
  int obstacle = -1;           ///< the nearest; -1: there is none
  Eigen::VectorXd place = {};  ///< the point of the move where it is nearest
  bool proved = true;          ///< `lower` holds for every point of the move; else for points along it only
};

/// Ability of a domain with obstacles, open sets that no path may enter (contact is allowed). Positions are ambient.
class ChecksMoves {
 public:
  virtual ~ChecksMoves() = default;
  /// Distance that the straight move from a to b keeps from what is forbidden.
  virtual MoveClearance clearance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const = 0;
  /// Whether two paths (ambient, d x m) between the same ends can be moved into each other without touching an
  /// obstacle; nothing where that is not known.
  virtual std::optional<bool> same_class(const Eigen::MatrixXd&, const Eigen::MatrixXd&) const { return std::nullopt; }
  /// What to call an obstacle in a message.
  virtual std::string obstacle_name(int obstacle) const = 0;
  /// Of a place that is nearer to an obstacle than it may be, by `missing` length units: how deep it lies inside of it,
  /// as "lies 0.2 deep inside the ball". Empty for one within the clearance alone, and where that is not known.
  virtual std::string depth_text(int /*obstacle*/, double /*missing*/) const { return ""; }
};

}  // namespace leastcost
