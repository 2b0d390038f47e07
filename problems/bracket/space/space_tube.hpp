// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "problems/bracket/space/space_level.hpp"

namespace leastcost::bracket {

/// The cells of a level that a path of at most `upper` may enter: the bounds from both ends add up to no more there.
/// Whoever enters another one pays more, proved. By place, in cells `parts` times as fine.
std::vector<Place> reached_cells(const SpaceMedium& medium, const SpaceLevel& coarse, const SpaceDistanceBound& from_s,
                                 const SpaceDistanceBound& from_t, double upper, int parts, const StopLook& look);

/// A finer level, of which these cells are searched, with the nodes around them that fronts need. `cells`: those of one
/// cube of 2^3 cells after each other.
SpaceLevel tube_level(const SpaceMedium& medium, const SpaceGrid& coarse, const std::vector<Place>& cells, int parts,
                      const StopLook& look);

}  // namespace leastcost::bracket
