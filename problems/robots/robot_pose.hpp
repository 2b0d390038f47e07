// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/problems/robots/robot.hpp>
#include "problems/robots/segment_distance.hpp"

namespace leastcost {

/// The links of a robot and the axes of its capsules in one configuration.
struct RobotPose {
  Eigen::VectorXd configuration;
  std::vector<Frame> links;
  std::vector<Segment3> axes;

  void place(const Robot& robot, const Eigen::VectorXd& at);
};

inline void RobotPose::place(const Robot& robot, const Eigen::VectorXd& at) {
  configuration = at;
  robot.kinematics->place(at, links);
  axes.resize(robot.capsules.size());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Capsule& capsule = robot.capsules[i];
    const Frame& link = links[static_cast<std::size_t>(capsule.link)];
    axes[i] = {link.at(capsule.from), link.at(capsule.to)};
  }
}

}  // namespace leastcost
