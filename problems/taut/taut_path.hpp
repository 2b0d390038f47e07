// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// The shortest path of its class among obstacles in the plane.
struct TautPath {
  Points polyline;    ///< 2 x m, clear of the obstacles
  double length = 0;  ///< of the polyline
  double least = 0;   ///< no path of the class is shorter: the length of the path along the circles, which it encloses
};

/// Of the class of `start`, a polyline 2 x m; `excess`: by which part the polyline may be longer than the least.
/// Nothing where `start` touches an obstacle, the walls are not made of discs (HasRounds), or no path is found that
/// is proved to be of the class. Throws Interrupted.
std::optional<TautPath> taut_path(const Walls& walls, const Points& start, double excess, const Deadline& deadline);

/// How far a polyline among obstacles turns, at most, at a corner that nothing holds: where all short cuts from one
/// side of the corner to the other are clear. Radians; 0 for a path that is taut. Asks the walls for clearances only,
/// and shares nothing with what makes such paths.
double unheld_turn(const Walls& walls, const Points& polyline, const Deadline& deadline);

}  // namespace leastcost
