// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// A box, in the plane a rectangle: in its frame with sides along the axes, between two corners or around the origin.
/// Its corners are sharp: it asks for a clearance.
struct BoxShapeOptions {
  Eigen::VectorXd lower = {};
  Eigen::VectorXd upper = {};
  Eigen::VectorXd size = {};  ///< its edges, in place of the corners
  ShapePose pose = {};        ///< in the plane and in space
  void fields(FieldVisitor& visit);
};

/// `name`: for messages; empty: by its place. Throws OptionError where the corners do not fit, the box is empty or the
/// pose does not fit.
std::shared_ptr<const Obstacle> make_box(const BoxShapeOptions& options, const std::string& name = {});

}  // namespace leastcost
