// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// The cost of the chain that the search begins with, and s0 (docs/numerics.md Sec. 1.2). Throws InitializationError
/// where the chain costs nothing or infinitely much.
void set_reference_cost(const Search& search, Outcome& out);

}  // namespace leastcost
