// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// All places nearer than `radius` to a point of a cloud in space.
struct PointObstacleOptions {
  std::string file = {};
  double radius = 0;
  ShapePose pose = {};  ///< of the frame that the points are in
  void fields(FieldVisitor& visit);
};

/// One obstacle of many points, at least one, by a hierarchy of balls; distances are exact to rounding. Throws
/// OptionError for a radius that is not positive.
std::shared_ptr<const Obstacle> make_point_obstacle(std::vector<Eigen::Vector3d> points, double radius,
                                                    const std::string& name);

/// Reads (relative to `folder`) and places them. Throws OptionError, InputError.
std::shared_ptr<const Obstacle> make_point_obstacle(const PointObstacleOptions& options,
                                                    const std::filesystem::path& folder);

}  // namespace leastcost
