// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/scene_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>
#include "catalogue/yaml/suggest.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

const std::vector<std::string>& shape_types() {
  static const std::vector<std::string> all = {"ball", "box", "capsule", "cone", "cylinder", "half_space", "mesh"};
  return all;
}

ShapePose read_pose(SceneBlock& block, Diagnostics& errors) {
  ShapePose pose;
  const ConfigNode* node = block.find("pose");
  if (node == nullptr) return pose;
  SceneBlock inner(*node, "the pose of " + block.what(), errors);
  pose.position = inner.numbers("position", 3);
  pose.rpy = inner.numbers("rpy", 3);
  pose.quaternion = inner.numbers("quaternion", 4);
  pose.rotation = inner.numbers("rotation", 3);
  inner.finish();
  return pose;
}

/// A point of space, placed. One that is missing or wrong was an error already.
Eigen::VectorXd placed_point(SceneBlock& block, const char* key, const Eigen::Isometry3d& pose) {
  if (!block.has(key)) block.required(key);
  const Eigen::VectorXd x = block.numbers(key, 3);
  return x.size() == 3 ? Vector3d(pose * Vector3d(x)) : Vector3d(Vector3d::Zero());
}

MeshInside read_inside(SceneBlock& block) {
  const std::string word = block.text("inside", "auto");
  for (const auto& known : words(MeshInside::closed))
    if (known.word == word) return known.value;
  block.fault("inside", "must be auto, solid or surface");
  return MeshInside::closed;
}

void read_shape(const std::string& type, const std::string& name, SceneBlock& block,
                const Eigen::Isometry3d& scene_pose, SceneObjects& scene) {
  if (type == "ball") {
    const BallOptions ball{placed_point(block, "center", scene_pose), block.number("radius")};
    return scene.add(block, [&] { return make_ball(ball, name); });
  }
  if (type == "capsule") {
    const CapsuleObstacleOptions capsule{placed_point(block, "from", scene_pose), placed_point(block, "to", scene_pose),
                                         block.number("radius")};
    return scene.add(block, [&] { return make_capsule(capsule, name); });
  }
  if (type == "half_space") {
    block.required("normal");
    const Eigen::VectorXd given = block.numbers("normal", 3);
    const Vector3d normal = given.size() == 3 ? Vector3d(scene_pose.linear() * Vector3d(given)) : Vector3d::UnitZ();
    const double offset = block.number("offset", 0.0) + normal.normalized().dot(scene_pose.translation());
    return scene.add(block, [&] { return make_half_space({normal, offset}, name); });
  }
  const ShapePose given = read_pose(block, scene.errors());
  const auto placed = [&] { return scene_pose * pose_of(given, 3); };
  if (type == "box") {
    BoxShapeOptions box{block.numbers("lower", 3), block.numbers("upper", 3), block.numbers("size", 3), {}};
    return scene.add(block, [&] {
      box.pose = shape_pose(placed());
      return make_box(box, name);
    });
  }
  if (type == "mesh") {
    const std::string file = block.text("file");
    const MeshInside inside = read_inside(block);
    const double scale = block.number("scale", 1.0), radius = block.number("radius", 0.0);
    return scene.add(block, [&] {
      if (!(scale > 0)) throw OptionError("scale", "must be greater than 0");
      if (!(radius >= 0)) throw OptionError("radius", "must be at least 0");
      return placed_mesh(read_mesh(scene.folder() / file), Vector3d::Constant(scale), placed(), inside, radius, name);
    });
  }
  const double radius = block.number("radius"), height = block.number("height");
  const double top = type == "cone" ? block.number("top_radius", 0.0) : 0;
  scene.add(block, [&] {
    const ShapePose pose = shape_pose(placed());
    return type == "cone" ? make_cone({radius, height, top, pose}, name) : make_cylinder({radius, height, pose}, name);
  });
}

}  // namespace

void SceneObjects::take_id(const std::string& id, SceneBlock& block, const char* key) {
  if (has(id)) block.fault(key, fmt::format("must be unique: {} is taken", in_quotes(id)));
  ids_.push_back(id);
}

bool SceneObjects::has(const std::string& id) const { return std::count(ids_.begin(), ids_.end(), id) > 0; }

void SceneObjects::add(SceneBlock& block, const std::function<Made()>& make, const char* file) {
  const std::size_t before = errors_.size();
  try {
    Made made = make();
    if (errors_.size() == before) all_.push_back(std::move(made));
  } catch (const OptionError& e) {
    block.fault(e.key(), e.reason());
  } catch (const InputError& e) {
    block.fault(file, std::string("cannot be read: ") + e.what());
  }
}

SceneObjects::Made placed_mesh(PolygonSoup soup, const Vector3d& scale, const Eigen::Isometry3d& pose,
                               MeshInside inside, double radius, const std::string& name) {
  for (Vector3d& p : soup.positions) p = pose * Vector3d(scale.cwiseProduct(p));
  return make_mesh_obstacle(TriangleMesh(soup, {.weld = true}), inside, radius, name);
}

void read_scene_shapes(const std::vector<ConfigNode>& objects, const Eigen::Isometry3d& pose,
                       const std::vector<std::string>& without, SceneObjects& scene) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const ConfigEntry* named = objects[i].find("id");
    const bool has_name = named != nullptr && named->value.is_scalar();
    SceneBlock block(objects[i], has_name ? "the object " + in_quotes(named->value.text) : fmt::format("object {}", i),
                     scene.errors());
    if (!objects[i].is_block()) continue;
    const std::string id = block.text("id"), type = block.text("type");
    scene.take_id(id, block, "id");
    if (std::count(without.begin(), without.end(), id) > 0) continue;
    const std::vector<std::string>& types = shape_types();
    if (std::count(types.begin(), types.end(), type) == 0) {
      if (block.has("type"))
        block.fault("type", fmt::format("is unknown: {}{}; valid types: {}", in_quotes(type), did_you_mean(type, types),
                                        joined(types)));
      continue;
    }
    read_shape(type, fmt::format("the {} {}", type, in_quotes(id)), block, pose, scene);
    block.finish();
  }
}

}  // namespace leastcost
