// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/problems/drawing/draws_poses.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// The configuration that lies a part of the path's length along it, 0 to 1.
Eigen::VectorXd along_path(const Points& configurations, double part);

/// A robot in space along a path through its configurations, and the obstacles that are not far off: at most half as
/// far as all that the robot sweeps is large. Of an obstacle that is neither convex nor says how it looks the box
/// around it is drawn, which is noted.
Workspace robot_workspace(const Robot& robot, const std::vector<std::shared_ptr<const Obstacle>>& obstacles,
                          const Points& configurations);

}  // namespace leastcost
