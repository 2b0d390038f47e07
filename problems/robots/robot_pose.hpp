// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <leastcost/problems/robots/robot.hpp>
#include "problems/robots/segment_distance.hpp"

namespace leastcost {

/// The links of a robot, the axes of its capsules and the triangles of its plates in one configuration.
struct RobotPose {
  Eigen::VectorXd configuration;
  std::vector<Frame> links;
  std::vector<Segment3> axes;
  std::vector<std::array<Eigen::Vector3d, 3>> plates;

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
  plates.resize(robot.plates.size());
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const Plate& plate = robot.plates[i];
    const Frame& link = links[static_cast<std::size_t>(plate.link)];
    plates[i] = {link.at(plate.corners[0]), link.at(plate.corners[1]), link.at(plate.corners[2])};
  }
}

}  // namespace leastcost
