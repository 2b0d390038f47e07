// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <leastcost/problems/robots/kinematics.hpp>

namespace leastcost {

/// Where a point of a link is to be, and how the link is to be turned.
struct ToolGoal {
  int link = 0;                                        ///< that the tool is fixed to
  Eigen::Vector3d tool = Eigen::Vector3d::Zero();      ///< coordinates of the link
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the tool in the workspace
  std::optional<Eigen::Matrix3d> rotation = {};        ///< of the link in the workspace; none: any
};

struct InverseOptions {
  int starts = 64;          ///< random configurations to start from, besides the one to be near to
  int most = 8;             ///< solutions
  double apart = 0.3;       ///< at least so far from each other, coordinates
  double tolerance = 1e-9;  ///< of the place of the tool and of points of the link, of the size of the robot
  std::uint64_t seed = 0;   ///< of the random starts
};

/// Configurations within the limits that bring the tool to its goal and that are allowed, nearest to `near` first.
/// Damped least squares (Levenberg and Marquardt) on the places of the tool and, with a rotation, of two points beside
/// it; then, where the robot has joints to spare, along the configurations that keep the tool there, towards `near`.
/// Empty: none was found, which is no proof that there is none. Throws OptionError("link"), OptionError("position"),
/// OptionError("rotation") for goals that are no numbers, no link or no rotation.
std::vector<Eigen::VectorXd> inverse_kinematics(const Kinematics& robot, const ToolGoal& goal,
                                                const Eigen::VectorXd& near,
                                                const std::function<bool(const Eigen::VectorXd&)>& allowed,
                                                const InverseOptions& options = {});

}  // namespace leastcost
