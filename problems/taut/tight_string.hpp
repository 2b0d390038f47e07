// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/monitor.hpp>
#include <leastcost/framework/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A path in space that is locally shortest among convex obstacles, as a polyline.
struct TightString {
  Points polyline;    ///< 3 x m, clear of the obstacles
  double length = 0;  ///< of the polyline
  /// By how much that is longer than the locally shortest path, as measured: the sides of the polyline touch the
  /// obstacles, and the polygon through the places where they do is shorter by about three halves of it.
  double excess = 0;
};

/// Pulls a polyline tight among convex obstacles in space. Each side is kept out of each obstacle beside it by a plane
/// between the two; with the planes held the least stretched string is a convex problem, whose solution is clear
/// because the planes are; then new planes, which touch where the string now is (successive convex approximation from
/// within: Marks and Wright 1978; the planes as in TrajOpt, Schulman et al. 2014). So no string is longer than the one
/// before it, and none goes through anything. It is split where it bends until the excess is at most that part of its
/// length; and it is pulled to one side and let go, so that it does not stay where it is balanced but not shortest.
/// `start`: clear of all walls, 3 x m. Nothing where it is not, an obstacle is not known to be convex, or it does not
/// come to rest. Throws Interrupted.
std::optional<TightString> tight_string(const Walls& walls, const Points& start, double excess, const Monitor& monitor);

/// What no obstacle holds of the bends of a polyline in space.
struct Unheld {
  double largest = 0;  ///< radians: what is left of a change of direction when the obstacles beside it have pushed
  double gain = 0;     ///< by how much, about, the polyline could be shorter for that and for gaps that it leans over
  /// The part of it for what pulls out of the planes of the bends, were the obstacles flat. Along round ones it is
  /// more.
  double sideways = 0;
};

/// Of a polyline, 3 x m, among convex obstacles. Asks the walls for planes only, and shares nothing with what makes
/// such strings.
Unheld unheld_bends(const Walls& walls, const Points& polyline);

}  // namespace leastcost
