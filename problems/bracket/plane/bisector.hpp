// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "problems/bracket/plane/level.hpp"

namespace leastcost::bracket {

/// A front from the places that are as far from one end as from the other: the signed cost to them is a potential
/// without a singularity at the ends, negative on the side of the source. `from_s`, `from_t`: distance fields.
Front front_at_bisector(const Level& level, const std::vector<double>& from_s, const std::vector<double>& from_t);

}  // namespace leastcost::bracket
