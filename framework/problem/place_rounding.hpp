// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// What rounding leaves of the distance between two neighbours of a chain whose positions a chart computes, relative:
/// points on the Earth are known to a nanometre, and a path may be a centimetre long. 0 where there is no chart.
double place_rounding(const Problem& problem, const CoordinatePath& chain);

}  // namespace leastcost
