// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/raster/raster_options.hpp>

namespace leastcost {

/// Which cells of a raster no path may enter, besides those without data.
struct RasterObstacleOptions {
  RasterOptions raster = {};  ///< whose values say what is blocked
  std::optional<double> above = {}, below = {};
  void fields(FieldVisitor& visit);
};

class RasterPatches;

/// Boxes in the plane that hold all places at which a function through the values has none for want of data, those
/// alone that a path from elsewhere would touch; the border of the raster is none of them. May be empty. `drawn`:
/// whether pictures show them.
std::vector<std::shared_ptr<const Obstacle>> void_obstacles(const RasterPatches& patches, bool drawn = true);

/// Boxes in the plane that hold the cells with a value above `above` or below `below`, and all places at which a
/// terrain or a smooth cost map from this raster has no value for want of data. Those alone that a path from elsewhere
/// would touch; the border of the raster is none of them. They ask for a clearance. Throws InputError where there are
/// none.
std::vector<std::shared_ptr<const Obstacle>> make_raster_obstacles(const RasterGrid& raster,
                                                                   const RasterObstacleOptions& options);

}  // namespace leastcost
