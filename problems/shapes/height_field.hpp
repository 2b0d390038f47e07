// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/raster/raster_options.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// Ground in space: heights over the x-y plane of its frame, and all that is below them.
struct HeightFieldOptions {
  RasterOptions raster = {};         ///< its file: empty where `heights` are given
  Eigen::MatrixXd heights = {};      ///< instead of a file: the first row is the northernmost; empty: of the file
  std::optional<double> depth = {};  ///< how far it reaches below its least height, length units
  ShapePose pose = {};               ///< of its frame
  void fields(FieldVisitor& visit);
};

/// Throws OptionError for options that cannot be, whatever the file says.
void check(const HeightFieldOptions& options);

/// The raster of `heights`, placed as one from a file. Throws OptionError, InputError.
RasterGrid raster_of_heights(const HeightFieldOptions& options);

/// One obstacle from heights in the middles of cells. Between them two triangles a square, cut from its lower left to
/// its upper right corner, are the surface; the outermost middles are its border. It is solid from there down to
/// `depth` (default: the diagonal of the field, so that no short way leads below it) under its least height. Distances
/// are exact to rounding. Throws OptionError, InputError where there are fewer than 2 x 2 heights, more than a million,
/// or one is missing.
std::shared_ptr<const Obstacle> make_height_field(const RasterGrid& heights, const HeightFieldOptions& options,
                                                  const std::string& name = {});

}  // namespace leastcost
