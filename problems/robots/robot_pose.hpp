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
  /// The links alone, and then one part: where a single one is asked for.
  void place_links(const Robot& robot, const Eigen::VectorXd& at);
  void place_part(const Robot& robot, std::size_t part);
};

inline void RobotPose::place(const Robot& robot, const Eigen::VectorXd& at) {
  place_links(robot, at);
  for (std::size_t part = 0; part < robot.parts(); ++part) place_part(robot, part);
}

inline void RobotPose::place_links(const Robot& robot, const Eigen::VectorXd& at) {
  configuration = at;
  robot.kinematics->place(at, links);
  axes.resize(robot.capsules.size());
  plates.resize(robot.plates.size());
}

inline void RobotPose::place_part(const Robot& robot, std::size_t part) {
  const Frame& link = links[static_cast<std::size_t>(robot.link(part))];
  if (part < axes.size()) {
    const Capsule& capsule = robot.capsules[part];
    axes[part] = {link.at(capsule.from), link.at(capsule.to)};
    return;
  }
  const Plate& plate = robot.plates[part - axes.size()];
  plates[part - axes.size()] = {link.at(plate.corners[0]), link.at(plate.corners[1]), link.at(plate.corners[2])};
}

}  // namespace leastcost
