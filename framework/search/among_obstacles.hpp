// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Adds to the failures of a certificate what the obstacles of the domain, if there are any, did to the path.
void judge_homotopy_class(const Search& search, Outcome& out);

}  // namespace leastcost
