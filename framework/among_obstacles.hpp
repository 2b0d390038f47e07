// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/find_path.hpp>

namespace leastcost {

/// By how much the straight moves of a chain touch what its points keep away from, units of the place; 0 where they do
/// not, by more than `allowed` of the size of the chain, or where the domain does not check moves. Throws Interrupted.
double depth_in_obstacles(const Problem& problem, const CoordinatePath& chain, double allowed,
                          const Deadline& deadline);

/// Adds to the failures of a certificate what the obstacles of the domain, if there are any, did to the path.
void judge_among_obstacles(const Problem& problem, Result& result);

}  // namespace leastcost
