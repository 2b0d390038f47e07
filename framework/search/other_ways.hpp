// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// The path goes to the coordinates that were given. Where it would be cheaper to go to others of the same point, a
/// note says so.
void note_cheaper_image(const Search& search, Outcome& out);

/// Where other ways cost no more, a certificate speaks of the value and not of the path.
void note_free_ways(const Search& search, Outcome& out);

}  // namespace leastcost
