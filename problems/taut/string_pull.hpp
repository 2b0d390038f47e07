// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A disc that a path bends around.
struct Bend {
  Round round;
  int side = 0;     ///< +1: counterclockwise, the disc is on the left; -1: clockwise
  double turn = 0;  ///< how far the path turns there, radians, counterclockwise
};

/// The discs around which a path in the plane bends once it is pulled tight, in order: its corners are cut one after
/// the other, each by the hull of what stands in the triangle of the corner and its neighbours. So the path never goes
/// through anything, and stays in its class. For each disc stand points of its circle, between which the path may cut
/// it (tangent_path() mends that). `start`: a polyline clear of all walls, 2 x m. Nothing where the walls are not made
/// of discs or it does not come to an end. Throws Interrupted.
std::optional<std::vector<Bend>> pull_string(const Walls& walls, const Points& start, const Deadline& deadline);

}  // namespace leastcost
