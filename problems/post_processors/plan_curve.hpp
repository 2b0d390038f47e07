// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// A path that is pulled tight, in the plane or in space.
struct TightPath {
  Points polyline;
  double length = 0;  ///< of the polyline
  double least = 0;   ///< what it may come down to: in the plane no path of the class is shorter
};

/// Why paths cannot be pulled tight among the obstacles of a problem; empty: they can.
std::string why_no_tight_path(const Problem& problem);

/// The obstacles of the plane or of space. Throws InputError, which begins with `who`, where there are none, where
/// those in the plane are not made of discs, and for rings.
const Walls& walls_of(const Problem& problem, const std::string& who);

/// The cost of a move of length one. Throws InputError where it is not the same in all directions.
double cost_of_length(const Problem& problem, const std::string& who);

/// The path becomes the curve that is delivered, with the chain's points on it. `unit`: cost of a move of length one.
/// False where it would leave the domain: nothing is changed then.
bool deliver_plan(const Problem& problem, const Walls& walls, double unit, const TightPath& path,
                  const Monitor& monitor, PostProcessed& current);

}  // namespace leastcost
