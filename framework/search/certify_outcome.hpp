// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Delivers the curve, certifies it, and judges what the certificate does not know of: kJudgements in the source.
void certify_outcome(const Search& search, Outcome& out);

}  // namespace leastcost
