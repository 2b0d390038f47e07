// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A path in space that is locally shortest among convex obstacles, as a polyline.
struct TightString {
  Points polyline;    ///< 3 x m, clear of the obstacles
  double length = 0;  ///< of the polyline
  /// By how much that is longer than the locally shortest path, as measured: by what the last cut has gained and by
  /// the polygon through the places where the sides touch the obstacles, and by what no obstacle holds of its bends.
  double excess = 0;
};

/// Pulls a polyline tight among convex obstacles in space. Each side is kept out of each obstacle beside it by a plane
/// between the two; with the planes held the least stretched string is a convex problem, whose solution is clear
/// because the planes are; then new planes, which touch where the string now is (successive convex approximation from
/// within: Marks and Wright 1978; the planes as in TrajOpt, Schulman et al. 2014). So no string is longer than the one
/// before it, and none goes through anything. Between pulls it is cut short where it bends, until the excess is at most
/// that part of its length; and it is pulled to one side and let go, so that it does not stay where it is balanced but
/// not shortest.
/// `start`: clear of all walls, 3 x m. Nothing where it is not, an obstacle is not known to be convex, or it does not
/// come to rest. Throws Interrupted.
std::optional<TightString> tight_string(const Walls& walls, const Points& start, double excess, const Monitor& monitor);

}  // namespace leastcost
