// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/begin.hpp"

namespace leastcost {

/// One search: first path or chain, solve, curve, certificate. with_more_points() and never_worse() come after it.
/// `problem`: its target receives the name that the first path leads to.
Result run_search(Problem& problem, const Begin& begin, const Search& search);

}  // namespace leastcost
