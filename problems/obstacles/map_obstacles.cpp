// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/map_obstacles.hpp>

#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>

namespace leastcost {

namespace {

using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

/// The blocked cells that are unknown, or those that are not; the others count as free here.
OccupancyGrid part_of_map(const OccupancyGrid& grid, bool unknown) {
  OccupancyGrid part = grid;
  for (std::size_t cell = 0; cell < grid.blocked.size(); ++cell)
    part.blocked[cell] = grid.blocked[cell] && grid.unknown[cell] == unknown;
  return part;
}

void add_cells(const OccupancyGrid& grid, const std::string& name, Obstacles& all) {
  for (const CellBox& box : blocking_boxes(grid))
    all.push_back(make_box_obstacle({grid.corner(box.row, box.column), grid.corner(box.row_end, box.column_end)},
                                    {.name = name}));
}

}  // namespace

std::vector<std::shared_ptr<const Obstacle>> map_obstacles(const OccupancyGrid& grid) {
  Obstacles all;
  if (grid.unknown.empty()) {
    add_cells(grid, BoxLook{}.name, all);
  } else {
    add_cells(part_of_map(grid, false), BoxLook{}.name, all);
    add_cells(part_of_map(grid, true), "the unknown cells (to let paths enter them, set `unknown: free` of the map)",
              all);
  }
  if (all.empty()) throw InputError(grid.source + ": the map has no blocked cell next to a free one");
  return all;
}

}  // namespace leastcost
