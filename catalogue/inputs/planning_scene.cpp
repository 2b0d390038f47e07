// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/planning_scene.hpp"

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/inputs/scene_objects.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "problems/readers/file_content.hpp"

namespace leastcost {
namespace {

bool has_items(const ConfigNode* node) { return node != nullptr && (!node->items.empty() || !node->entries.empty()); }

/// "'can' on panda_hand, 'box' on panda_hand"
std::string named(const ConfigNode& attached) {
  std::string list;
  const auto text = [](const ConfigNode* node) { return node != nullptr && node->is_scalar() ? node->text : "?"; };
  for (const ConfigNode& one : attached.items)
    list += (list.empty() ? "" : ", ") + in_quotes(text(node_at(one, "object.id"))) + " on " +
            text(node_at(one, "link_name"));
  return list;
}

/// Of both layouts; neither is an error.
void read_layout(const ConfigNode& tree, const Eigen::Isometry3d& pose, const std::vector<std::string>& without,
                 SceneObjects& scene, const std::function<void(std::string)>& note) {
  SceneBlock root(tree, "the scene", scene.errors());
  if (!tree.is_block()) return;
  if (root.has("objects")) {
    read_scene_shapes(root.list("objects"), pose, without, scene);
    return root.finish();
  }
  if (!root.has("world") && !root.has("collision_objects")) {
    scene.errors().error(tree.place, "a scene has 'objects', or 'world: {collision_objects: ..}' as MoveIt writes it");
    return;
  }
  if (root.has("world")) {
    SceneBlock world(*root.find("world"), "'world'", scene.errors());
    read_collision_objects(world.list("collision_objects"), pose, without, scene);
    if (has_items(node_at(tree, "world.octomap.octomap.data")) || has_items(node_at(tree, "world.octomap.data")))
      world.fault("octomap", "is not read: remove its data");
  } else {
    read_collision_objects(root.list("collision_objects"), pose, without, scene);
  }
  if (const ConfigNode* attached = node_at(tree, "robot_state.attached_collision_objects"); note && has_items(attached))
    note("the scene's attached objects are not read: " + named(*attached) +
         "; what the robot carries is an option of the robot: 'attached: [{link: .., type: box, size: [..]}]'");
}

}  // namespace

void PlanningSceneOptions::fields(FieldVisitor& visit) {
  visit.file("file", file,
             {.help = "Scene file (YAML): objects with poses, or a planning scene of MoveIt.", .required = true});
  visit_pose(visit, pose);
  visit.field("without", without, {.help = "Ids of objects that are left out."});
}

std::vector<std::shared_ptr<const Obstacle>> read_planning_scene(const PlanningSceneOptions& options,
                                                                 const std::filesystem::path& folder,
                                                                 const std::function<void(std::string)>& note) {
  const Eigen::Isometry3d pose = pose_of(options.pose, 3);
  const std::filesystem::path file = folder / options.file;
  const std::string text = read_content(file);
  Diagnostics errors(file.string(), text);
  const ConfigNode tree = read_yaml(text, errors);
  SceneObjects scene(file.parent_path(), errors);
  if (errors.empty()) read_layout(tree, pose, options.without, scene, note);
  if (!errors.empty()) throw InputError(errors.render() + errors.count());
  for (const std::string& id : options.without)
    if (!scene.has(id)) throw OptionError("without", "there is no object " + in_quotes(id) + " in the scene");
  if (scene.all().empty()) throw InputError(file.string() + ": the scene has no objects");
  return std::move(scene.all());
}

}  // namespace leastcost
