// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/robots/robot.hpp>

namespace leastcost {

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

/// The robot of a URDF file: coordinates are the joints that move, in the order of the tree. Joints without motion are
/// merged away: links that stand still against each other are one, named by the one that moves first. Shapes are the
/// collision shapes, covered by capsules. Parts of links are kept apart that move against each other and whose pair the
/// SRDF does not disable; without an SRDF, those that no more than one link with a shape lies between.
/// Files are relative to `folder`. Throws InputError("file:line: ...") for files that are wrong, OptionError for
/// options that do not fit them.
std::shared_ptr<const Robot> make_urdf_robot(const UrdfRobotOptions& options, const std::filesystem::path& folder);

/// "9.0.0".
std::string tinyxml2_version();

}  // namespace leastcost
