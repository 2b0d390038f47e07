// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// A cone in space, or a frustum of one: in its frame around the z axis, its base at -height / 2 and its top at
/// height / 2. It is sharp: it asks for a clearance.
struct ConeOptions {
  double radius = 0, height = 0;  ///< of the base, and from the base to the tip; length units
  double top_radius = 0;          ///< 0: a cone with a tip
  ShapePose pose = {};            ///< where it stands
  void fields(FieldVisitor& visit);
};

/// `name`: for messages; empty: by its place. Throws OptionError for sizes that are not positive (the top may be 0) and
/// poses that do not fit.
std::shared_ptr<const Obstacle> make_cone(const ConeOptions& options, const std::string& name = {});

}  // namespace leastcost
