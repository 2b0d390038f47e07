// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/distance/distance_grid.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// An obstacle in space, given by its signed distance on a regular grid.
struct GridObstacleOptions {
  std::string file = {};
  double radius = 0;        ///< thickness around it, length units
  double memory_limit = 1;  ///< GiB
  void fields(FieldVisitor& visit);
};

/// Where the spline through the values is below 0 and, with a radius, around it. What counts as the distance is the
/// spline divided by the largest slope that it may have (bounds_above) where it is above half a cell within, so that it
/// is nowhere more than the distance from the obstacle and proofs rest on it; the slope is 1 for exact distances in
/// cells small beside what they are from, and a clearance is that many times larger where it is more. Deeper than half
/// a cell nothing counts as deeper.
///
/// Beyond the grid it goes on as the distance from the grid's box and the value at its nearest place. `name` is for
/// messages. Throws InputError where the values on the border of the grid may be 0 or less: the obstacle would go on
/// beyond it; and for a grid that is nowhere above that depth.
std::shared_ptr<const Obstacle> make_grid_obstacle(DistanceGrid grid, double radius, const std::string& name);

/// Reads (relative to `folder`). Throws OptionError, InputError.
std::shared_ptr<const Obstacle> make_grid_obstacle(const GridObstacleOptions& options,
                                                   const std::filesystem::path& folder);

}  // namespace leastcost
