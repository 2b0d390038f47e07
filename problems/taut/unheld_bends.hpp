// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// What no obstacle holds of the bends of a polyline in space.
struct Unheld {
  double largest = 0;  ///< radians: what is left of a change of direction when the obstacles beside it have pushed
  double gain = 0;     ///< by how much, about, the polyline could be shorter for that and for gaps that it leans over
  /// The part of it for what pulls out of the planes of the bends, were the obstacles flat. Along round ones it is
  /// more.
  double sideways = 0;
};

/// Of a polyline, 3 x m, among convex obstacles. Asks the walls for planes only, and shares nothing with what makes
/// such strings. Throws Interrupted.
Unheld unheld_bends(const Walls& walls, const Points& polyline, const Deadline& deadline = {});

}  // namespace leastcost
