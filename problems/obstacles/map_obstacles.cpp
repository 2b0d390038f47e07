// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/map_obstacles.hpp>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>

namespace leastcost {

std::vector<std::shared_ptr<const Obstacle>> map_obstacles(const OccupancyGrid& grid) {
  std::vector<std::shared_ptr<const Obstacle>> all;
  for (const CellBox& box : blocking_boxes(grid))
    all.push_back(make_box_obstacle({grid.corner(box.row, box.column), grid.corner(box.row_end, box.column_end)}));
  if (all.empty()) throw InputError(grid.source + ": the map has no blocked cell beside a free one");
  return all;
}

}  // namespace leastcost
