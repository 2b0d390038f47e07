// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/mapped_walls.hpp"

#include <memory>
#include <vector>

#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

/// A ball and a box; places are (y, z, x) where they have no more than these.
std::shared_ptr<const Walls> in_space() {
  return std::make_shared<const ObstacleWalls>(
      3,
      ObstacleWalls::Obstacles{make_ball({Vector3d(1, 0, 0), 0.3}),
                               make_box_obstacle({Vector3d(-1, -1, -1), Vector3d(-0.5, 1, 1)})},
      0.1);
}

MappedWalls turned() { return {3, {2, 0, 1}, in_space()}; }

std::shared_ptr<const RobotWalls> of_arm() {
  return std::make_shared<const RobotWalls>(make_dh_arm({}),
                                            RobotWalls::Obstacles{make_ball({Vector3d(0.55, 0, 0.45), 0.12})}, 0.02);
}

/// The joints of the arm from the last to the first.
MappedWalls backwards(std::shared_ptr<const Walls> arm) { return {7, {6, 5, 4, 3, 2, 1, 0}, std::move(arm)}; }

Points path_of_arm() {
  Points path(7, 2);
  path.col(0) << -1.2, 0.4, 0, -1.8, 0, 2.2, 0.7;
  path.col(1) << 0.1, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5;
  return path;
}

}  // namespace

TEST_CASE("mapped walls: gaps, slopes, rooms and planes are those of the place that is meant") {
  const auto walls = in_space();
  const MappedWalls mapped = turned();
  const Vector3d a(0.2, 0.1, 0.4), b(0.4, -0.3, 0.3);
  const auto there = [](const Vector3d& x) { return Vector3d(x[1], x[2], x[0]); };
  std::vector<Wall> found, inner;
  for (const bool along : {false, true}) {
    walls->near(a, 10, inner);
    mapped.near(there(a), 10, found);
    if (along) walls->along(a, b, 10, inner);
    if (along) mapped.along(there(a), there(b), 10, found);
    REQUIRE(found.size() == 2);
    REQUIRE(inner.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(found[i].gap == inner[i].gap);
      CHECK(found[i].slope == there(inner[i].slope));
    }
  }
  CHECK(mapped.room(there(a), there(b), 5) == walls->room(a, b, 5));
  CHECK(mapped.clearance(there(a), there(b)).place == there(walls->clearance(a, b).place));
  CHECK(clears(mapped, there(a), there(b)));
  CHECK_FALSE(clears(mapped, there(a), there({1, 0, 0})));
  std::vector<SupportPlane> planes, plain;
  REQUIRE(find_ability<HasSupportPlanes>(mapped)->planes(there(a), there(b), 10, planes));
  REQUIRE(find_ability<HasSupportPlanes>(*walls)->planes(a, b, 10, plain));
  REQUIRE(planes.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(planes[i].normal == there(plain[i].normal));
    CHECK(planes[i].place == there(plain[i].place));
    CHECK(planes[i].normal.dot(there(a)) >= planes[i].offset);
  }
}

TEST_CASE("mapped walls: no ability of the walls is lost, whatever they are wrapped in") {
  CHECK(find_ability<GapsAreDistances>(turned()) != nullptr);
  CHECK(find_ability<GapsAreDistances>(backwards(of_arm())) == nullptr);
  CHECK(find_ability<DrawsPoses>(turned()) == nullptr);

  const auto arm = of_arm();
  const MappedWalls mapped = backwards(arm);
  const std::shared_ptr<const Walls> cached = remembering(mapped);
  REQUIRE(cached != nullptr);
  CHECK(remembering(*cached) != nullptr);
  const Points path = path_of_arm(), there = path.colwise().reverse();
  for (const Walls* walls : {static_cast<const Walls*>(&mapped), cached.get()}) {
    const auto* poses = find_ability<DrawsPoses>(*walls);
    REQUIRE(poses != nullptr);
    const PoseStrip strip = poses->pose_strip(there), known = arm->pose_strip(path);
    REQUIRE(strip.poses.size() == known.poses.size());
    CHECK(strip.poses.back() == known.poses.back());
    CHECK(find_ability<DecidesMoves>(*walls) != nullptr);
    CHECK(clears(*walls, there.col(0), there.col(1)) == arm->clears(path.col(0), path.col(1)));
    std::vector<Wall> found, inner;
    walls->near(there.col(0), 1, found);
    arm->near(path.col(0), 1, inner);
    REQUIRE(found.size() == inner.size());
    REQUIRE_FALSE(found.empty());
    CHECK(found[0].slope == inner[0].slope.reverse());
  }
  Drawing drawing;
  find_ability<DrawsItself>(*cached)->draw({}, drawing);
  CHECK(drawing.notes.size() == 1);  // that of the arm, from under two wraps
}

TEST_CASE("mapped walls: what is left out changes no gap, and discs of the plane are none of poses") {
  const auto plane =
      std::make_shared<const ObstacleWalls>(2, ObstacleWalls::Obstacles{make_ball({Vector2d(1, 0), 0.3})}, 0.1);
  const MappedWalls poses(4, {0, 1}, plane);
  CHECK(find_ability<HasRounds>(*plane) != nullptr);
  CHECK(find_ability<HasRounds>(poses) == nullptr);
  CHECK(find_ability<GapsAreDistances>(poses) != nullptr);
  std::vector<Wall> found;
  poses.near(Vector4d(0, 0, 5, 6), 1, found);
  REQUIRE(found.size() == 1);
  CHECK(found[0].gap == Approx(0.6));
  CHECK(found[0].slope == Vector4d(-1, 0, 0, 0));
  CHECK(remembering(poses) == nullptr);
  std::vector<SupportPlane> planes;
  CHECK_FALSE(poses.planes(Vector4d(0, 0, 5, 6), Vector4d(0, 1, 5, 6), 1, planes));
}

}  // namespace leastcost::test
