// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// Which robot of a URDF file, and how it stands.
struct UrdfRobotOptions {
  std::string file = {};
  std::string srdf = {};
  std::string group = {};                              ///< of the SRDF: whose joints move; empty: all
  std::map<std::string, double> hold = {};             ///< values of joints that do not move
  std::string hold_state = {};                         ///< of the SRDF: values of the others
  bool soft_limits = true;                             ///< those of a safety_controller, where they are narrower
  std::string packages = {};                           ///< folder of packages for package:// names of meshes
  Eigen::VectorXd position = Eigen::Vector3d::Zero();  ///< of the root link
  Eigen::VectorXd rpy = Eigen::Vector3d::Zero();       ///< its roll, pitch and yaw, rad
  void fields(FieldVisitor& visit);
};

}  // namespace leastcost
