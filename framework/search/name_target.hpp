// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/search/search.hpp"

namespace leastcost {

/// Where coordinates are a name only (HasImages), the target is called by the name that the path should lead to, unless
/// FindOptions::target_as_given.

/// From one side of a pole to the other the straight line in coordinates goes round the pole, and a chain that follows
/// it jumps: the name over the pole, where the way there is cheaper.
void name_target_over_pole(const Search& search, Outcome& out);

/// Waypoints round the axis lead to another name of the target than the one nearest to the source.
void name_target_of_first_path(const Search& search, Outcome& out);

}  // namespace leastcost
