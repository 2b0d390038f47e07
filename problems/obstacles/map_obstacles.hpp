// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/occupancy/occupancy_grid.hpp>

namespace leastcost {

/// The blocked cells of a map as boxes, those that no path can reach before others left out. The border of the map is
/// no wall. Throws InputError for a map without blocked cells.
std::vector<std::shared_ptr<const Obstacle>> map_obstacles(const OccupancyGrid& grid);

}  // namespace leastcost
