// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "problems/cells/cell_map.hpp"

namespace leastcost {

/// The least-cost path by straight moves within cells, between corners and `points` places on each side: A*. With 3 of
/// them, or 4 k + 3, every move of a grid path to 8 or 16 neighbours is among them, between the centres of cells. Empty
/// where there is no path. Both ends must touch a cell that is finite. `look` is called now and then, and may throw.
CellPath least_cell_path(const CellMap& map, const Eigen::Vector2d& source, const Eigen::Vector2d& target, int points,
                         const std::function<void()>& look = {});

}  // namespace leastcost
