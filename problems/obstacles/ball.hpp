// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// A ball, in the plane a disc.
struct BallOptions {
  Eigen::VectorXd center = {};
  double radius = 0;
  void fields(FieldVisitor& visit);
};

/// `name`: for messages; empty: by its place. Throws OptionError for a centre that is no point and a radius that is not
/// positive.
std::shared_ptr<const Obstacle> make_ball(const BallOptions& options, const std::string& name = {});

}  // namespace leastcost
