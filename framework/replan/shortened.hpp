// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Makes an open path lead between the ends of the problem, which may have moved since it was made: what lies before
/// the place nearest to the new source, and behind that nearest to the new target, is left out. Distances are in
/// coordinates. Returns whether anything changed.
bool shorten_to_ends(const Problem& problem, CoordinatePath& path);

}  // namespace leastcost
