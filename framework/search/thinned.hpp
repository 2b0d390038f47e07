// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// What is delivered of a finer chain: the points that were asked for, every `factor`-th, with its curve and its
/// certificate.

/// Where moves between so few might touch an obstacle, all of them. A note says which.
Result thinned(const Problem& problem, Result finer, Index factor, const Search& search);

/// On a mesh kinks push points along the path wherever they meet them, however many points there are. What has to be
/// equally spaced are the points that are delivered, every `factor`-th of the chain.
void judge_delivered_spacing(const Problem& problem, Index factor, Result& finer);

}  // namespace leastcost
