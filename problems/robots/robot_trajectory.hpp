// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/trajectory/trajectory.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// With the velocities of the robot's file where none are given. Throws OptionError("velocity") where the file has none
/// for a joint, OptionError("acceleration") where that is not given: no file of a robot has it.
TrajectoryOptions with_limits_of(const Robot& robot, TrajectoryOptions options);

}  // namespace leastcost
