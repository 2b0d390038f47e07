// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <leastcost/framework/trajectory/trajectory.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

/// The limits that are not given, from a joint_limits.yaml as MoveIt has it: `max_velocity` and `max_acceleration` of
/// joints, by their names, where `has_velocity_limits` and `has_acceleration_limits` are true; velocities of the others
/// are those of the robot's file. Both are scaled by the file's `default_velocity_scaling_factor` and
/// `default_acceleration_scaling_factor`, as MoveIt moves by default, which `note` is told. Throws InputError with the
/// lines that are wrong, OptionError("limits") for a robot without names of joints and for a file without any of them,
/// OptionError("velocity"), ("acceleration") for a joint without one.
TrajectoryOptions with_joint_limits(const std::filesystem::path& file, const Robot& robot, TrajectoryOptions options,
                                    const std::function<void(std::string)>& note);

}  // namespace leastcost
