// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "problems/cells/cell_map.hpp"

namespace leastcost {

/// A path whose moves through neighbouring cells of equal cost are straight where that is no dearer: only places where
/// the cost changes, and corners that it turns around, are left to Newton; what lies between is cut from straight
/// lines. Over plateaus this is exact beside corners too, where two places on sides lie so near to each other that
/// Newton on all places does not find them apart.
CellPath with_straight_runs(const CellMap& map, const CellPath& path);

}  // namespace leastcost
