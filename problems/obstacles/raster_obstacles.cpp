// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/raster_obstacles.hpp>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/occupancy/occupancy_grid.hpp>
#include "framework/base/point_text.hpp"
#include "problems/raster/raster_patches.hpp"

namespace leastcost {
namespace {

using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

template <class Blocked>
OccupancyGrid grid_of(int rows, int columns, const Blocked& blocked) {
  OccupancyGrid grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.blocked.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) grid.blocked[grid.index(row, column)] = blocked(row, column);
  return grid;
}

/// The boxes of a grid whose cells have other sides.
void add_boxes(const OccupancyGrid& grid, const Eigen::Vector2d& lower, const Eigen::Vector2d& cell, bool drawn,
               Obstacles& all) {
  for (const CellBox& box : blocking_boxes(grid))
    all.push_back(make_box_obstacle({lower + cell.cwiseProduct(grid.corner(box.row, box.column)),
                                     lower + cell.cwiseProduct(grid.corner(box.row_end, box.column_end))},
                                    {.drawn = drawn}));
}

}  // namespace

void RasterObstacleOptions::fields(FieldVisitor& visit) {
  raster.fields(visit);
  visit.field("above", above, {.help = "Cells with a larger value are also obstacles."});
  visit.field("below", below, {.help = "Cells with a smaller value are also obstacles."});
}

std::vector<std::shared_ptr<const Obstacle>> void_obstacles(const RasterPatches& patches, bool drawn) {
  Obstacles all;
  add_boxes(grid_of(patches.rows(), patches.columns(), [&](int r, int c) { return !patches.known(r, c); }),
            patches.lower(), patches.cell(), drawn, all);
  return all;
}

std::vector<std::shared_ptr<const Obstacle>> make_raster_obstacles(const RasterGrid& raster,
                                                                   const RasterObstacleOptions& options) {
  Obstacles all = void_obstacles(RasterPatches(raster, 1, 2));
  const auto forbidden = [&](int row, int column) {
    const double value = raster.value(row, column);
    return (options.above && value > *options.above) || (options.below && value < *options.below);
  };
  if (options.above || options.below)
    add_boxes(grid_of(raster.rows, raster.columns, forbidden), raster.corner, raster.cell, true, all);
  if (all.empty())
    throw InputError(raster.source + ": no cell of the raster is an obstacle: there is none without data" +
                     (options.above ? ", none above " + short_number(*options.above, 9) : "") +
                     (options.below ? ", none below " + short_number(*options.below, 9) : ""));
  return all;
}

}  // namespace leastcost
