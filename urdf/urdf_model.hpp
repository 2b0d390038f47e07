// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace leastcost {

namespace urdf_shape {

struct Sphere {
  double radius = 0;
};
/// Around the z axis, its middle in the origin. With round ends: half balls beyond its length.
struct Cylinder {
  double radius = 0, length = 0;
  bool round_ends = false;
};
struct Box {
  Eigen::Vector3d size;
};
struct Mesh {
  std::string name;  ///< as it stands in the file
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
};

}  // namespace urdf_shape

struct UrdfCollision {
  Eigen::Affine3d origin = Eigen::Affine3d::Identity();  ///< in the frame of the link
  std::variant<urdf_shape::Sphere, urdf_shape::Cylinder, urdf_shape::Box, urdf_shape::Mesh> shape;
  std::string place;  ///< "file:line", for messages
};

struct UrdfLink {
  std::string name;
  std::vector<UrdfCollision> collisions = {};
  int parent_joint = -1;  ///< -1: the root
};

struct UrdfMimic {
  int joint = -1;
  double factor = 1, offset = 0;
};

struct UrdfJoint {
  enum class Kind { fixed, turns, slides, unsupported };
  std::string name, type;
  Kind kind = Kind::fixed;
  int parent = -1, child = -1;  ///< links
  Eigen::Affine3d origin = Eigen::Affine3d::Identity();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  /// Infinite for a continuous one. Of one that others mimic: where they are within their limits, too.
  double lower = 0, upper = 0;
  double soft_lower = 0, soft_upper = 0;                      ///< the same, narrowed by its safety_controller
  double velocity = std::numeric_limits<double>::infinity();  ///< per s; infinite: the file says none
  std::optional<UrdfMimic> mimic = {};                        ///< of one that follows another

  bool moves() const { return kind == Kind::turns || kind == Kind::slides; }
};

/// What a URDF says about links and joints.
struct UrdfModel {
  std::string file;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;  ///< of a tree, parents before children, each branch down to its end
  int root = 0;
  std::vector<std::string> notes = {};  ///< for people: where it is not taken as it stands

  int find_link(const std::string& name) const;  ///< -1: there is none
  int find_joint(const std::string& name) const;
  /// The joints from a link up to the root.
  std::vector<int> joints_above(int link) const;
};

/// Throws InputError("file:line: ...") for what is no tree of links and joints.
UrdfModel read_urdf(const std::filesystem::path& file);

}  // namespace leastcost
