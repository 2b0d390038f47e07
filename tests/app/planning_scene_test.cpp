// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/planning_scene.hpp"

#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Eigen::Vector3d;
using Vector = Eigen::VectorXd;
using Obstacles = std::vector<std::shared_ptr<const Obstacle>>;

struct SceneFolder {
  ScratchDir folder;
  std::vector<std::string> notes = {};

  Obstacles read(const std::string& text, PlanningSceneOptions options = {}) {
    std::ofstream(folder.path() / "scene.yaml") << text;
    options.file = "scene.yaml";
    return read_planning_scene(options, folder.path(), [&](std::string note) { notes.push_back(std::move(note)); });
  }
  std::string fault(const std::string& text, const PlanningSceneOptions& options = {}) {
    try {
      read(text, options);
    } catch (const InputError& e) {
      return e.what();
    } catch (const OptionError& e) {
      return e.key() + ": " + e.reason();
    }
    return "none";
  }
  void tetrahedron(const std::string& name) const {
    std::ofstream(folder.path() / name) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  }
};

double distance(const Obstacle& obstacle, const Vector3d& x) {
  Vector away(3);
  return obstacle.distance(Vector(x), away) - obstacle.radius();
}

}  // namespace

TEST_CASE("planning scenes: all shapes of our own layout, placed with the scene") {
  SceneFolder scene;
  scene.tetrahedron("tetra.obj");
  PlanningSceneOptions options;
  options.pose.position = Vector3d(10, 0, 0);
  options.pose.rpy = Vector3d(0, 0, std::acos(0.0));  // x goes to y
  const Obstacles all = scene.read(R"(
objects:
  - {id: ball, type: ball, center: [1, 0, 0], radius: 0.5}
  - {id: box, type: box, size: [2, 4, 6], pose: {position: [3, 0, 0]}}
  - {id: corners, type: box, lower: [0, 0, 0], upper: [1, 1, 1]}
  - {id: can, type: cylinder, radius: 1, height: 2, pose: {position: [0, 5, 0], rpy: [1.5707963267948966, 0, 0]}}
  - {id: hat, type: cone, radius: 1, height: 2}
  - {id: bar, type: capsule, from: [0, 0, 0], to: [0, 0, 3], radius: 0.1}
  - {id: floor, type: half_space, normal: [0, 0, 3], offset: -1}
  - {id: wall, type: half_space, normal: [1, 0, 0]}
  - {id: tetra, type: mesh, file: tetra.obj, scale: 2, pose: {position: [0, 0, 1]}}
)",
                                   options);
  REQUIRE(all.size() == 9);
  const std::vector<std::string> names = {"ball 'ball'",        "box 'box'",         "box 'corners'",
                                          "cylinder 'can'",     "cone 'hat'",        "capsule 'bar'",
                                          "half_space 'floor'", "half_space 'wall'", "mesh 'tetra'"};
  for (std::size_t i = 0; i < names.size(); ++i) CHECK(all[i]->name() == "the " + names[i]);
  CHECK(distance(*all[0], Vector3d(10, 3, 0)) == Approx(1.5));
  CHECK(distance(*all[1], Vector3d(10, 7, 0)) == Approx(3));  // 2 wide along y, 4 along x
  CHECK(distance(*all[1], Vector3d(13, 3, 0)) == Approx(1));
  CHECK(distance(*all[2], Vector3d(9.5, 3, 0.5)) == Approx(2));
  CHECK(distance(*all[3], Vector3d(8, 0, 0)) == Approx(2));  // it lies along x, from 4 to 6
  CHECK(distance(*all[3], Vector3d(5, 0, 4)) == Approx(3));
  CHECK(distance(*all[4], Vector3d(10, 0, 5)) == Approx(4));
  CHECK(distance(*all[5], Vector3d(10, 2, 1)) == Approx(1.9));
  CHECK(distance(*all[6], Vector3d(0, 0, 1)) == Approx(2));
  CHECK(distance(*all[7], Vector3d(0, 4, 0)) == Approx(4));
  CHECK(distance(*all[8], Vector3d(10, 0, 4)) == Approx(1));
  options.without = {"hat", "floor"};
  CHECK(scene
            .read("objects: [{id: hat, type: cone, radius: 1, height: 1}, {id: floor, type: half_space, normal: [0, "
                  "0, 1]}, {id: b, type: ball, center: [0, 0, 0], radius: 1}]",
                  options)
            .size() == 1);
}

/// Quaternions of ROS have w last, cylinders their height first, and poses of parts are in the frame of the object.
TEST_CASE("planning scenes: those of MoveIt") {
  SceneFolder scene;
  scene.tetrahedron("tetra.obj");
  const Obstacles all = scene.read(R"(
name: (noname)
robot_state:
  attached_collision_objects: [{link_name: hand, object: {id: can}}]
world:
  collision_objects:
    - id: table
      header: {frame_id: world}
      primitives:
        - type: box
          dimensions: [2, 4, 0.2]
      primitive_poses:
        - position: [1, 0, 0.5]
          orientation: [0, 0, 0.70710678118654752, 0.70710678118654752]
      operation: add
    - id: two
      header: {frame_id: world}
      pose: {position: {x: 10, y: 0, z: 0}, orientation: {x: 0, y: 0, z: 0.70710678118654752, w: 0.70710678118654752}}
      primitives: [{type: 3, dimensions: [2, 0.5]}, {type: sphere, dimensions: [0.5]}]
      primitive_poses: [{position: [0, 0, 1]}, {position: [3, 0, 0], orientation: [0, 0, 0, 1]}]
    - id: cone
      primitives: [{type: 4, dimensions: [2, 1]}]
    - id: mesh
      meshes: [{resource: tetra.obj, dimensions: [1, 2, 3]}]
      mesh_poses: [{position: [0, 0, 1]}]
    - id: inline
      meshes:
        - vertices: [[0, 0, 0], {x: 1, y: 0, z: 0}, [0, 1, 0], [0, 0, 1]]
          triangles: [[0, 2, 1], {vertex_indices: [0, 1, 3]}, [1, 2, 3], [0, 3, 2]]
    - id: ground
      planes: [{coef: [0, 0, 2, 1]}]
  octomap: {}
)");
  REQUIRE(all.size() == 7);
  CHECK(all[0]->name() == "the box 'table'");
  CHECK(distance(*all[0], Vector3d(4, 0, 0.5)) == Approx(1));  // turned: 4 along x
  CHECK(distance(*all[0], Vector3d(1, 2, 0.5)) == Approx(1));
  CHECK(all[1]->name() == "the cylinder 'two' (primitives 0)");
  CHECK(distance(*all[1], Vector3d(10, 0, 3)) == Approx(1));
  CHECK(distance(*all[1], Vector3d(12, 0, 1)) == Approx(1.5));
  CHECK(distance(*all[2], Vector3d(10, 4, 0)) == Approx(0.5));
  CHECK(distance(*all[3], Vector3d(0, 0, 3)) == Approx(2));
  CHECK(distance(*all[4], Vector3d(0, 0, 5)) == Approx(1));  // three times as high, from 1
  CHECK(distance(*all[5], Vector3d(0.1, 0.1, 0.1)) < 0);     // solid
  CHECK(distance(*all[6], Vector3d(5, 5, 1)) == Approx(1.5));
  REQUIRE(scene.notes.size() == 1);
  CHECK_THAT(scene.notes[0],
             Contains("attached objects are not read: 'can' on hand; ") && Contains("attached: [{link: .."));
}

TEST_CASE("planning scenes: faults have the line of the scene's file") {
  SceneFolder scene;
  const std::string many = scene.fault(R"(objects:
  - {id: a, type: box, size: [1, 2]}
  - {id: a, type: bax, size: [1, 2, 3]}
  - {id: c, type: cylinder, radius: 1, height: 0}
  - {id: d, type: ball, center: [0, 0, 0], radius: 1, colour: red}
  - {id: e, type: box, size: [1, 1, 1], pose: {position: [0, 0, 0], rpy: [0, 0, 1], rotation: [0, 0, 1]}}
  - {id: f, type: mesh, file: missing.obj}
  - {type: ball, center: [0, 0, 0], radius: 1}
  - 7
)");
  CHECK_THAT(many, Contains("scene.yaml:2:") && Contains("'size' in the object 'a' must be a list of 3 numbers"));
  CHECK_THAT(many, Contains("scene.yaml:3:") && Contains("must be unique") && Contains("did you mean 'box'?"));
  CHECK_THAT(many, Contains("scene.yaml:4:") && Contains("'height' in the object 'c' must be a number greater than 0"));
  CHECK_THAT(many, Contains("scene.yaml:5:") && Contains("unknown key 'colour' in the object 'd'"));
  CHECK_THAT(many, Contains("scene.yaml:6:") && Contains("at most one of rpy"));
  CHECK_THAT(many, Contains("scene.yaml:7:") && Contains("'file' in the object 'f' cannot be read"));
  CHECK_THAT(many, Contains("scene.yaml:8:") && Contains("missing key 'id' in object 6"));
  CHECK_THAT(many, Contains("scene.yaml:9:") && Contains("object 7 must be a block of keys"));
  CHECK_THAT(scene.fault("- 1\n"), Contains("the scene must be a block"));
  CHECK_THAT(scene.fault("boxes: []\n"), Contains("scene.yaml:1:1") && Contains("a scene has 'objects'"));
  CHECK_THAT(scene.fault("objects: []\n"), Contains("the scene has no objects"));
  CHECK_THAT(scene.fault("world: {collision_objects: [{id: a, primitives: [{type: box, dimensions: [1, 1]}]}]}\n"),
             Contains("'dimensions' in the object 'a' must be a list of 3 numbers"));
  CHECK_THAT(
      scene.fault("world:\n  collision_objects:\n    - id: a\n      meshes: [{resource: 'package://x/y.stl'}]\n"),
      Contains("scene.yaml:4:") && Contains("packages are not looked up"));
  CHECK_THAT(
      scene.fault("world:\n  collision_objects:\n    - {id: a, header: {frame_id: world}}\n    - {id: b, header: "
                  "{frame_id: base}}\n"),
      Contains("scene.yaml:4:") && Contains("must be 'world', the frame of the objects before it"));
  CHECK_THAT(scene.fault("world: {collision_objects: [{id: a, primitives: [{type: box, dimensions: [1, 1, 1]}], "
                         "primitive_poses: [{orientation: [0, 0, 0, 0]}]}]}\n"),
             Contains("'orientation' in the pose of the object 'a' must not be zero"));
  PlanningSceneOptions options;
  options.without = {"nobody"};
  CHECK_THAT(scene.fault("objects: [{id: b, type: ball, center: [0, 0, 0], radius: 1}]\n", options),
             Contains("without: there is no object 'nobody'"));
}

}  // namespace leastcost::test
