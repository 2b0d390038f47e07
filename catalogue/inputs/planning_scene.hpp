// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>
#include <leastcost/problems/shapes/shape_pose.hpp>

namespace leastcost {

/// Objects with poses, in a file of their own.
struct PlanningSceneOptions {
  std::string file = {};
  ShapePose pose = {};                    ///< of the scene
  std::vector<std::string> without = {};  ///< objects that are left out, by id
  void fields(FieldVisitor& visit);
};

/// The obstacles of a scene in space, in the order of the file, each called by its id. Two layouts are read
/// (docs/domains.md "Planning scenes"): `objects`, a list of shapes as a configuration has them, each with an `id`; and
/// `world: {collision_objects: ..}` as MoveIt writes planning scenes, whose robot is not read. Meshes are relative to
/// the scene's file. `note`: told what is not read. Throws OptionError, and InputError with all faults at their lines.
std::vector<std::shared_ptr<const Obstacle>> read_planning_scene(const PlanningSceneOptions& options,
                                                                 const std::filesystem::path& folder,
                                                                 const std::function<void(std::string)>& note);

}  // namespace leastcost
