// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// Where a shape stands: it is turned about the origin of its own frame, then moved to `position`. At most one of the
/// rotations is given.
struct ShapePose {
  Eigen::VectorXd position = {};     ///< length units; empty: the origin
  Eigen::VectorXd rpy = {};          ///< roll, pitch, yaw about the fixed axes x, y, z in this order, radians
  Eigen::VectorXd quaternion = {};   ///< w, x, y, z; of any length but 0
  Eigen::VectorXd rotation = {};     ///< axis times angle, radians
  std::optional<double> angle = {};  ///< in the plane, counterclockwise, radians
  void fields(FieldVisitor& visit);
};

/// Visits them as the block `pose`.
void visit_pose(FieldVisitor& visit, ShapePose& pose);

/// In the plane about the z axis, z being 0. Throws OptionError("pose.<key>") where it does not fit the dimension, 2
/// or 3, and for more than one rotation.
Eigen::Isometry3d pose_of(const ShapePose& options, Eigen::Index dimension);

/// The options that say this pose in space.
ShapePose shape_pose(const Eigen::Isometry3d& pose);

}  // namespace leastcost
