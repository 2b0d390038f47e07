// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/occupancy/grey_image.hpp"

namespace leastcost {

OccupancyGrid occupancy_of(const GreyImage& image, const OccupancyOptions& options) {
  OccupancyGrid grid = placed_grid(options);
  grid.rows = image.rows;
  grid.columns = image.columns;
  grid.source = image.source;
  grid.blocked.resize(image.values.size());
  const double white = image.maximum;
  for (int row = 0; row < image.rows; ++row)
    for (int column = 0; column < image.columns; ++column) {
      const double value = image.values[grid.index(row, column)];
      const double occupancy = (options.negate ? value : white - value) / white;
      const bool known = occupancy > options.occupied_thresh || occupancy < options.free_thresh;
      const bool blocked = known ? occupancy > options.occupied_thresh : options.unknown == UnknownCells::blocked;
      grid.blocked[grid.index(image.rows - 1 - row, column)] = blocked;
      if (known) continue;
      grid.unknown.resize(grid.blocked.size());
      grid.unknown[grid.index(image.rows - 1 - row, column)] = true;
    }
  return grid;
}

}  // namespace leastcost
