// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// A cylinder with flat ends in space: in its frame around the z axis, from -height / 2 to height / 2. Its edges are
/// sharp: it asks for a clearance.
struct CylinderOptions {
  double radius = 0, height = 0;  ///< length units
  ShapePose pose = {};            ///< where its centre is
  void fields(FieldVisitor& visit);
};

/// `name`: for messages; empty: by its place. Throws OptionError for sizes that are not positive and poses that do not
/// fit.
std::shared_ptr<const Obstacle> make_cylinder(const CylinderOptions& options, const std::string& name = {});

}  // namespace leastcost
