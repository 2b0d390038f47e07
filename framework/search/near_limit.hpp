// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Of a certified path among obstacles whose number of points was left to the search: goes on with twice as many, up to
/// 1,600, until they cost no more than a hundredth above the limit of more points. Margins between few points take up
/// what little room there is. A chain that is not certified, or costs no less, is not taken. Notes say what was done,
/// and where the points still cost more. Throws nothing of the chains that could not be made.
Result near_limit(const Problem& problem, Result found, const Search& search);

}  // namespace leastcost
