// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Solves the chain, coarse to fine under FindOptions::cascade, with margins that fit it where the domain has some.
void solve_chain(const Search& search, Outcome& out);

/// Leaves saddles to their lower side, under FindOptions::escape_saddle.
void leave_saddles(const Search& search, Outcome& out);

}  // namespace leastcost
