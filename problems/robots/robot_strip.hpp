// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/problems/drawing/draws_poses.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// Some poses of a robot along a path, evenly spread over its length, and the obstacles: from above in the plane, from
/// a corner above in space, there also as surfaces. Of an obstacle that is neither a ball nor a box the box around it
/// is drawn. The hand is the origin of the last link's frame: the flange of an arm, the origin of a body.
PoseStrip robot_strip(const Robot& robot, const std::vector<std::shared_ptr<const Obstacle>>& obstacles,
                      const Points& configurations);

}  // namespace leastcost
