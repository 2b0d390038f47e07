// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/problems/bracket/search/box_bracket.hpp>

namespace leastcost {

/// Around all cells that were searched on the last grid, for a picture.
PotentialSamples samples_of(const BracketPotential& potential);

}  // namespace leastcost
