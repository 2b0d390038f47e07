// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/robot_trajectory.hpp>

#include <cmath>
#include <cstddef>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

TrajectoryOptions with_limits_of(const Robot& robot, TrajectoryOptions options) {
  if (!options.velocity && robot.velocity.size() > 0) {
    for (Eigen::Index i = 0; i < robot.velocity.size(); ++i)
      if (!std::isfinite(robot.velocity[i]))
        throw OptionError("velocity",
                          "is needed: the robot's file has none for the joint '" +
                              (robot.joints.empty() ? std::to_string(i) : robot.joints[static_cast<std::size_t>(i)]) +
                              "'; give one number for all joints, or a list with one for each");
    options.velocity = robot.velocity;
  }
  if (!options.acceleration)
    throw OptionError(
        "acceleration",
        "is needed: files of robots have none; give one number for all joints, or a list with one for each "
        "(rad/s^2), like max_acceleration in a joint_limits.yaml of MoveIt");
  return options;
}

}  // namespace leastcost
