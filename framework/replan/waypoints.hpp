// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// How many waypoints, or how far apart: exactly one of the two.
struct WaypointOptions {
  std::optional<int> count = {};       ///< the ends included; at least 2, of a ring 3
  std::optional<double> spacing = {};  ///< units of the cost, so seconds where it is a time; > 0
  void fields(FieldVisitor& visit);
  bool wanted() const { return count || spacing; }  ///< whether any are asked for
};

/// Points of a delivered path, equally spaced in its cost.
struct Waypoints {
  CoordinatePath path;        ///< in coordinates, the ends included; a ring does not repeat its first point
  Points x;                   ///< ambient positions, ambient x count
  Eigen::VectorXd cost;       ///< of the path from its first point to each; where the cost is a time, when to be there
  double total = 0;           ///< cost of the whole path
  std::optional<double> gap;  ///< by which straight moves between the points cost more (less: < 0); none: infinitely
  /// Of the straight moves between them, which may cut corners that the path goes around; nothing without obstacles.
  std::optional<Clearance> clearance;
  bool touches = false;  ///< whether these come too near, or nobody knows, by more than 1e-9 of the size of the path
};

/// Places points on the delivered curve (between the points of the chain on its straight moves, which keep what the
/// path keeps) at equal shares of its cost, or so far apart; then the last move has what is left. Within a move the
/// share is found by what the cost says of its parts. In a chart the moves are straight in the coordinates. Throws
/// OptionError("count"), OptionError("spacing"), InputError for a path that is not there or has no finite cost,
/// Interrupted.
Waypoints place_waypoints(const Problem& problem, const Result& result, const WaypointOptions& options,
                          const Deadline& deadline = {});

}  // namespace leastcost
