// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// A ball, in the plane a disc.
struct BallOptions {
  Eigen::VectorXd center = {};
  double radius = 0;
  void fields(FieldVisitor& visit);
};

/// Throws OptionError for a centre that is no point and a radius that is not positive.
std::shared_ptr<const Obstacle> make_ball(const BallOptions& options);

}  // namespace leastcost
