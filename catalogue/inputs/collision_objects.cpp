// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>
#include "catalogue/inputs/scene_objects.hpp"

namespace leastcost {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

/// geometry_msgs/Pose: position [x, y, z], orientation [x, y, z, w], or both with names.
Isometry3d read_ros_pose(const ConfigNode& node, const std::string& of, Diagnostics& errors) {
  SceneBlock block(node, "the pose of " + of, errors);
  Isometry3d pose = Isometry3d::Identity();
  const auto read = [&](const char* key, std::size_t count, const std::vector<std::string>& names) {
    const ConfigNode* given = block.find(key);
    std::string fault;
    auto numbers = given == nullptr ? std::nullopt : numbers_of(*given, count, names, fault);
    if (!fault.empty()) block.fault(key, fault);
    return numbers;
  };
  if (const auto position = read("position", 3, {"x", "y", "z"})) pose.translation() = *position;
  if (const auto q = read("orientation", 4, {"x", "y", "z", "w"})) {
    if (!(q->norm() > 0))
      block.fault("orientation", "must not be zero: no rotation is [0, 0, 0, 1]");
    else
      pose.linear() = pose_of({.quaternion = Eigen::Vector4d((*q)[3], (*q)[0], (*q)[1], (*q)[2])}, 3).linear();
  }
  return pose;
}

/// One of the lists of a collision object and that of its poses, one for each; poses may be left out where the object
/// has one of its own.
template <class Add>
void read_parts(SceneBlock& object, const char* key, const char* poses_key, const Isometry3d& pose, Diagnostics& errors,
                const Add& add) {
  const std::vector<ConfigNode> parts = object.list(key), poses = object.list(poses_key);
  if (!poses.empty() && poses.size() != parts.size())
    return object.fault(poses_key, fmt::format("must be as many as {} ({}, not {})", key, parts.size(), poses.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string number = parts.size() > 1 ? fmt::format(" ({} {})", key, i) : "";
    SceneBlock part(parts[i], object.what() + number, errors);
    const Isometry3d own = poses.empty() ? Isometry3d::Identity() : read_ros_pose(poses[i], part.what(), errors);
    if (parts[i].is_block()) add(part, pose * own, number);
  }
}

/// shape_msgs/SolidPrimitive, its type as a word or a number.
void add_primitive(SceneBlock& part, const Isometry3d& pose, const std::string& id, SceneObjects& scene) {
  static constexpr std::array<const char*, 4> kTypes = {"box", "sphere", "cylinder", "cone"};
  static constexpr std::array<std::size_t, 4> kDimensions = {3, 1, 2, 2};
  const std::string type = part.text("type");
  std::size_t which = 0;
  while (which < 4 && type != kTypes[which] && type != std::to_string(which + 1)) ++which;
  if (which == 4) {
    if (part.has("type")) part.fault("type", "must be box, sphere, cylinder or cone, or their numbers 1 to 4");
    return;
  }
  part.required("dimensions");
  const Eigen::VectorXd size = part.numbers("dimensions", kDimensions[which]);
  if (size.size() == 0) return;  // was an error
  if (!(size.array() > 0).all()) return part.fault("dimensions", "must be greater than 0");
  const std::string name = fmt::format("the {} {}", kTypes[which], id);
  const ShapePose where = shape_pose(pose);
  scene.add(part, [&]() -> SceneObjects::Made {
    if (which == 0) return make_box({{}, {}, size, where}, name);
    if (which == 1) return make_ball({pose.translation(), size[0]}, name);
    if (which == 2) return make_cylinder({size[1], size[0], where}, name);
    return make_cone({size[1], size[0], 0, where}, name);
  });
}

/// A list of three numbers for each item, in a block under `name` where the item is one.
std::vector<Vector3d> read_triples(SceneBlock& part, const char* key, const char* name) {
  std::vector<Vector3d> out;
  for (const ConfigNode& item : part.list(key)) {
    const ConfigEntry* inner = item.find(name);
    std::string fault;
    const auto numbers = numbers_of(inner != nullptr ? inner->value : item, 3, {"x", "y", "z"}, fault);
    if (!numbers) {
      part.fault(key, fault);
      return {};
    }
    out.emplace_back(*numbers);
  }
  return out;
}

PolygonSoup soup_of(const std::vector<Vector3d>& vertices, const std::vector<Vector3d>& triangles,
                    const std::string& source) {
  PolygonSoup soup{vertices, {}, {0}, source};
  for (const Vector3d& triangle : triangles) {
    for (const double corner : triangle) {
      if (!(corner >= 0 && corner < static_cast<double>(vertices.size())) || corner != std::floor(corner))
        throw OptionError("triangles", fmt::format("refers to vertex {} of {}", corner, vertices.size()));
      soup.corners.push_back(static_cast<std::int32_t>(corner));
    }
    soup.polygon_begin.push_back(static_cast<std::int32_t>(soup.corners.size()));
  }
  return soup;
}

/// Of a file (`resource`, scaled by `dimensions`), or its vertices and triangles.
void add_mesh(SceneBlock& part, const Isometry3d& pose, const std::string& id, SceneObjects& scene) {
  const std::string name = "the mesh " + id;
  if (!part.has("resource")) {
    const std::vector<Vector3d> vertices = read_triples(part, "vertices", "");
    const std::vector<Vector3d> triangles = read_triples(part, "triangles", "vertex_indices");
    return scene.add(part, [&] {
      if (vertices.empty() || triangles.empty())
        throw OptionError("vertices", "are missing: a mesh has a resource, or vertices and triangles");
      return placed_mesh(soup_of(vertices, triangles, id), Vector3d::Ones(), pose, MeshInside::closed, 0, name);
    });
  }
  std::string file = part.text("resource");
  Eigen::VectorXd scale = part.numbers("dimensions", 3);
  if (scale.size() == 0) scale = Vector3d::Ones();
  scene.add(
      part,
      [&] {
        if (file.starts_with("file://")) file = file.substr(7);
        if (file.find("://") != std::string::npos)
          throw OptionError("resource", "must be a path, relative to the scene's file: packages are not looked up");
        if (!(scale.array() > 0).all()) throw OptionError("dimensions", "must be greater than 0");
        return placed_mesh(read_mesh(scene.folder() / file), scale, pose, MeshInside::closed, 0, name);
      },
      "resource");
}

/// shape_msgs/Plane: a x + b y + c z + d = 0; what is below is the obstacle.
void add_plane(SceneBlock& part, const Isometry3d& pose, const std::string& id, SceneObjects& scene) {
  part.required("coef");
  const Eigen::VectorXd coef = part.numbers("coef", 4);
  if (coef.size() == 0) return;
  const Vector3d own = coef.head<3>(), normal = pose.linear() * own;
  if (!(own.norm() > 0)) return part.fault("coef", "must have a normal: its first three are 0");
  const double offset = -coef[3] / own.norm() + normal.normalized().dot(pose.translation());
  scene.add(part, [&] { return make_half_space({normal, offset}, "the plane " + id); });
}

}  // namespace

void read_collision_objects(const std::vector<ConfigNode>& objects, const Isometry3d& scene_pose,
                            const std::vector<std::string>& without, SceneObjects& scene) {
  std::optional<std::string> frame;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const ConfigEntry* named = objects[i].find("id");
    const bool has_name = named != nullptr && named->value.is_scalar();
    SceneBlock object(objects[i],
                      has_name ? "the object " + in_quotes(named->value.text) : fmt::format("collision object {}", i),
                      scene.errors());
    if (!objects[i].is_block()) continue;
    const std::string id = object.text("id"), operation = object.text("operation", "add");
    scene.take_id(id, object, "id");
    if (std::count(without.begin(), without.end(), id) > 0) continue;
    if (operation != "add" && operation != "0")
      object.fault("operation", "must be add: a scene is read as it stands, without changes to another");
    if (const ConfigNode* stated = node_at(objects[i], "header.frame_id"); stated != nullptr && stated->is_scalar()) {
      if (frame && *frame != stated->text)
        object.fault(
            "header.frame_id",
            fmt::format("must be {}, the frame of the objects before it: a scene has one frame", in_quotes(*frame)));
      frame = stated->text;
    }
    Isometry3d pose = scene_pose;
    if (const ConfigNode* own = object.find("pose")) pose = pose * read_ros_pose(*own, object.what(), scene.errors());
    const auto called = [&](const std::string& number) { return in_quotes(id) + number; };
    read_parts(object, "primitives", "primitive_poses", pose, scene.errors(),
               [&](SceneBlock& part, const Isometry3d& at, const std::string& number) {
                 add_primitive(part, at, called(number), scene);
               });
    read_parts(object, "meshes", "mesh_poses", pose, scene.errors(),
               [&](SceneBlock& part, const Isometry3d& at, const std::string& number) {
                 add_mesh(part, at, called(number), scene);
               });
    read_parts(object, "planes", "plane_poses", pose, scene.errors(),
               [&](SceneBlock& part, const Isometry3d& at, const std::string& number) {
                 add_plane(part, at, called(number), scene);
               });
  }
}

}  // namespace leastcost
