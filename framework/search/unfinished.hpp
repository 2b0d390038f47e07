// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "framework/search/search.hpp"

namespace leastcost {

/// The best path of a solve in which the cost, or another part of the problem, threw or contradicted itself: nothing is
/// measured about it.
void leave_unmeasured(Outcome& out);

/// The best path so far of an interrupted search, with as much as can be measured in the time that is left.
void leave_unfinished(const Search& search, const std::string& why, Outcome& out);

}  // namespace leastcost
