// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Goes on with twice the points where that may help, until the path is certified, or refused for another reason, or
/// comes no closer, or there are no more doublings, points, work or time (docs/numerics.md Sec. 6.2). What is not
/// certified then stays as it came, with a note; but where the first path is better than that and not better than the
/// finer chain, the finer chain is delivered.
Result with_more_points(const Problem& problem, Result found, const Search& search);

}  // namespace leastcost
