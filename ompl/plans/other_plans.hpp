// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include "ompl/plans/plan_space.hpp"

namespace leastcost {

/// Whether cheapest_plan() can look for others: a flat space, or one of poses within bounds, with a length of a
/// constant metric, among walls that tell quickly whether a move is clear.
bool can_plan(const PlanSpace& space);

/// What is pulled tight stays on the side of the obstacles on which it was given. So up to `trees` plans of random
/// trees among the walls stand beside the given one; the cheapest few are pulled tight, roughly. Returns the cheapest,
/// or the given plan where none is cheaper. Among poses, where pulling takes long, the plans are put together instead
/// (PlanRoadmap): the cheapest way along pieces of them. Without a deadline the same plan gives the same; before one,
/// plans and pulls leave a third of the time. `problem`: its domain has the walls of the space.
Points cheapest_plan(const PlanSpace& space, const Problem& problem, const Points& given, int trees,
                     const Monitor& monitor);

}  // namespace leastcost
