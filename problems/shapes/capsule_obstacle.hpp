// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// All points nearer than `radius` to a segment, in the plane or in space.
struct CapsuleObstacleOptions {
  Eigen::VectorXd from = {}, to = {};
  double radius = 0;
  void fields(FieldVisitor& visit);
};

/// `name`: for messages; empty: by its place. Throws OptionError for ends that are no two points of the plane or of
/// space, and a radius that is not positive.
std::shared_ptr<const Obstacle> make_capsule(const CapsuleObstacleOptions& options, const std::string& name = {});

}  // namespace leastcost
