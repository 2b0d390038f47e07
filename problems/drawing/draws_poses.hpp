// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>

namespace leastcost {

/// A part of a robot in space that is fixed to a link: all points within a radius of a segment, length units.
struct DrawnCapsule {
  std::size_t link = 0;                                                          ///< that it moves with
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< coordinates of the link
  double radius = 0;                                                             ///< length units
};

/// The same of a triangle, drawn without a thickness.
struct DrawnPlate {
  std::size_t link = 0;                         ///< that it moves with
  std::array<Eigen::Vector3d, 3> corners = {};  ///< a triangle, coordinates of the link
};

/// Where a link is.
struct DrawnFrame {
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< rotation of the link
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();          ///< origin of the link in space
};

/// A robot on its way in space, and the obstacles there as surfaces.
struct Workspace {
  Eigen::Vector3d lower = Eigen::Vector3d::Zero();  ///< lower corner of what is worth a look
  Eigen::Vector3d upper = Eigen::Vector3d::Zero();  ///< and the upper one
  std::vector<DrawnCapsule> capsules;               ///< of the robot
  std::vector<DrawnPlate> plates;                   ///< of the robot
  std::vector<std::vector<DrawnFrame>> poses;       ///< evenly spread along the path, its ends included; of every link
  TriangleSoup obstacles;                           ///< of finite size
  TriangleSoup ground;  ///< of half-spaces, as far as the corners; counterclockwise seen from where it is free
  std::string unit;     ///< of lengths; empty: not known
  std::vector<std::string> notes;  ///< what is not shown as it is

  bool empty() const { return poses.empty(); }  ///< whether there is nothing to show
};

/// A robot on its way, seen from one side: closed polylines in the plane of the picture, 2 x m each.
struct PoseStrip {
  std::vector<std::vector<Points>> poses;  ///< from the first to the last, each the outlines of its parts
  std::vector<Points> obstacles;           ///< of the workspace
  Points hand;                             ///< the way of its last link, or of a body, 2 x points of the path
  Points hand_in_space;                    ///< the same in the workspace, 3 x points of the path; z is 0 in the plane
  Workspace workspace;                     ///< of a robot in space; else empty
};

/// Ability of a domain whose points are configurations of something that can be drawn in its workspace.
class DrawsPoses {
 public:
  virtual ~DrawsPoses() = default;
  bool present() const { return has_poses(); }
  /// Of a path through the configurations, dimension x m, m at least 1.
  virtual PoseStrip pose_strip(const Points& configurations) const = 0;

 private:
  virtual bool has_poses() const = 0;
};

}  // namespace leastcost
