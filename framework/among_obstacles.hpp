// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/find_path.hpp>

namespace leastcost {

/// How far a curve may seem to go into an obstacle that it touches: `allowed` of its size, and the last digits of its
/// coordinates, which far from the origin are more.
double contact_tolerance(const Points& x, double allowed);

/// By how much the straight moves of a chain touch what its points keep away from, units of the place; 0 where they do
/// not, by more than contact_tolerance(), or where the domain does not check moves. Throws Interrupted.
double depth_in_obstacles(const Problem& problem, const CoordinatePath& chain, double allowed,
                          const Deadline& deadline);

/// Adds to the failures of a certificate what the obstacles of the domain, if there are any, did to the path.
void judge_among_obstacles(const Problem& problem, Result& result);

}  // namespace leastcost
