// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/ompl/forward.hpp>

namespace leastcost {

/// What a planner that optimises minimises: the sum of our costs of the moves, in the rows of StateColumns; a state by
/// itself costs nothing. Its heuristic is 0, which no cost undercuts. Throws InputError for a space that StateColumns
/// does not know and a cost of another dimension.
std::shared_ptr<ompl::base::OptimizationObjective> make_objective(
    const std::shared_ptr<ompl::base::SpaceInformation>& space, std::shared_ptr<const SegmentCost> cost);

}  // namespace leastcost
