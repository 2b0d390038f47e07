// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include "catalogue/inputs/scene_block.hpp"

namespace leastcost {

/// The obstacles of a scene while it is read.
class SceneObjects {
 public:
  using Made = std::shared_ptr<const Obstacle>;

  SceneObjects(std::filesystem::path folder, Diagnostics& errors) : folder_(std::move(folder)), errors_(errors) {}

  const std::filesystem::path& folder() const { return folder_; }
  Diagnostics& errors() { return errors_; }
  std::vector<Made>& all() { return all_; }

  /// Notes the id of an object; one that is taken is an error at `key` of the block.
  void take_id(const std::string& id, SceneBlock& block, const char* key);
  bool has(const std::string& id) const;
  /// Adds what `make` returns; an OptionError becomes an error at its key of the block, an InputError one at `file`.
  void add(SceneBlock& block, const std::function<Made()>& make, const char* file = "file");

 private:
  std::filesystem::path folder_;
  Diagnostics& errors_;
  std::vector<Made> all_;
  std::vector<std::string> ids_;
};

/// Scaled along the axes, then placed.
SceneObjects::Made placed_mesh(PolygonSoup soup, const Eigen::Vector3d& scale, const Eigen::Isometry3d& pose,
                               MeshInside inside, double radius, const std::string& name);

/// The shapes of `objects`, which a configuration has too, and in addition an `id`.
void read_scene_shapes(const std::vector<ConfigNode>& objects, const Eigen::Isometry3d& pose,
                       const std::vector<std::string>& without, SceneObjects& scene);

/// `collision_objects` of MoveIt: those of moveit_msgs/PlanningScene.
void read_collision_objects(const std::vector<ConfigNode>& objects, const Eigen::Isometry3d& pose,
                            const std::vector<std::string>& without, SceneObjects& scene);

}  // namespace leastcost
