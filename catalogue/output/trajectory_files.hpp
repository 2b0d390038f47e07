// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/framework/trajectory/trajectory.hpp>

namespace leastcost {

/// trajectory.csv: time, the coordinates, and of each the velocity and the acceleration. All digits.
std::string trajectory_csv(const Trajectory& motion, const std::vector<std::string>& names);

/// trajectory.json, with the fields of ROS's trajectory_msgs/JointTrajectory: joint_names, points with positions,
/// velocities, accelerations and time_from_start.
std::string trajectory_json(const Trajectory& motion, const std::vector<std::string>& names);

}  // namespace leastcost
