// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/begin.hpp"

namespace leastcost {

/// One search, from a first path or a chain to a certificate, but for its last two steps: neither more points, nor the
/// first path where that is better (see with_more_points() and never_worse()). `problem`: its target receives the name
/// that the first path leads to.
Result run_search(Problem& problem, const Begin& begin, const Search& search);

}  // namespace leastcost
