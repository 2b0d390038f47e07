// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// Where the tool of a robot is to be: a point of a link, and how the link is turned.
struct ToolPose {
  std::string link = {};        ///< by its name; empty: the last one
  Eigen::VectorXd offset = {};  ///< of the tool, coordinates of the link; empty: its origin
  ShapePose pose = {};          ///< of the tool in the workspace, turned as the link is; no rotation: any
  void fields(FieldVisitor& visit);
  bool given() const { return pose.position.size() > 0; }  ///< whether a pose was given at all
};

/// Who says where the ends of a run are. The caller: a configuration need not have them.
enum class EndsFrom { configuration, caller };

/// Where an end of the path is: exactly one of vertex, face + barycentric, point, lonlat, state; of a target also
/// points or tool, each of which is several ends: the one that is cheapest to reach is taken.
struct EndOptions {
  std::optional<int> vertex = {};                   ///< of the file
  std::optional<int> face = {};                     ///< of the file
  std::optional<Eigen::VectorXd> barycentric = {};  ///< three numbers
  std::optional<Eigen::VectorXd> point = {};
  std::optional<Eigen::VectorXd> lonlat = {};  ///< on the Earth: longitude, latitude, degrees
  std::optional<std::string> state = {};       ///< of the robot, by its name
  std::optional<Eigen::MatrixXd> points = {};  ///< one a row
  ToolPose tool = {};                          ///< a pose of the tool, which a robot reaches by several configurations
  std::optional<double> tolerance = {};        ///< of a point, length units; else the default of the manifold
  void fields(FieldVisitor& visit);

  /// How many of these ways are given.
  int ways() const;
  /// Whether it stands for several ends, of which the cheapest is taken.
  bool is_several() const { return points || tool.given(); }
  /// The words of the error for an end that is given in no way, or in two.
  static constexpr const char* kWays = "must have exactly one of: vertex; face and barycentric; point; lonlat; state";
  /// The same for a target.
  static constexpr const char* kWaysOfTarget =
      "must have exactly one of: vertex; face and barycentric; point; lonlat; state; points; tool";
};

}  // namespace leastcost
