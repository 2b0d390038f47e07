// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// A loop with a fixed point as the open path that it is: from that point to itself, or to its image where the loop
/// crosses the seams of a chart.
struct BasedLoop {
  Problem problem;
  FirstPath first;
};

/// Cuts a first ring open where it is nearest to the source of `problem` (a ring with a fixed point, Problem::based)
/// and joins both ends to that point by straight moves, in coordinates.
BasedLoop cut_at_base(const Problem& problem, const FirstPath& ring);

}  // namespace leastcost
