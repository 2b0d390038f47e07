// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "problems/bracket/plane/distance_bound.hpp"

namespace leastcost::bracket {

/// How many cells of a level a path of at most `upper` may enter.
long reached_cells(const Level& level, const DistanceBound& from_s, const DistanceBound& from_t, double upper);

/// A finer level, of which those cells are searched that a path of at most `upper` may enter: the bounds from both ends
/// add up to no more there. What leaves them costs more than `upper`, proved.
Level tube_level(const Medium& medium, const Level& coarse, const DistanceBound& from_s, const DistanceBound& from_t,
                 double upper, int parts, const StopLook& look);

}  // namespace leastcost::bracket
