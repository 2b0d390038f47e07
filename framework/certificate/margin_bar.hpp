// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/newton/refinement.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// By how much the least cost may lie below the finest level because of the margins that points keep (FitsSegments), as
/// far as differences between the levels do not tell. A margin that falls at second order is a part of what
/// extrapolation sees; one that stays as it is, because a single point touches on every level, makes no difference
/// between any two of them. Units of the cost; 0 for a domain without margins. Throws Interrupted.
double margin_bar(const Problem& problem, const Refinement& refinement, const Deadline& deadline);

}  // namespace leastcost
