// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/plans/plan_roadmap.hpp"

#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include "ompl/plans/plan_trees.hpp"
#include "ompl/plans/tighten.hpp"
#include "tests/ompl/plans.hpp"

namespace leastcost::test {
namespace {

/// A bar among walls x = 0 to 0.6, with a hole at y = 0.6 to 1.8.
struct BarAtAWall {
  PlannerSpace space = open_space(poses());
  StateColumns columns{space->getStateSpace()};
  PlanSpace plans{space, columns, columns.domain(), columns.length()};

  BarAtAWall() {
    Robot body;
    body.kinematics = std::make_shared<const SpatialBody>();
    body.capsules = {{0, {-0.8, 0, 0}, {0.8, 0, 0}, 0.2}};
    RobotWalls::Obstacles slabs;
    for (const auto& [low, high] : {std::pair{-20.0, 0.6}, {1.8, 9.3}}) {
      ShapePose pose;
      pose.position = Eigen::Vector3d(0, (low + high) / 2, 0);
      slabs.push_back(make_box({.size = Eigen::Vector3d(0.6, high - low, 20), .pose = pose}));
    }
    plans.look_at(
        make_pose_walls(columns, std::make_shared<RobotWalls>(make_robot(std::move(body)), std::move(slabs), 0)));
  }
};

/// Poses that are not turned.
Points unturned(const Eigen::Matrix2Xd& places) {
  Points x = Points::Zero(7, places.cols());
  x.topRows(2) = places;
  x.row(6).setOnes();
  return x;
}

}  // namespace

TEST_CASE("plan roadmap: the good halves of two plans, by whatever name of a quaternion, make one way") {
  const BarAtAWall scene;
  Points first = unturned((Eigen::Matrix2Xd(2, 4) << -3, -1.5, 1.5, 3, 0, 1.2, 1.2, 5).finished());
  first.col(3) = unturned(Eigen::Vector2d(3, 0));
  Points slow_at_last = unturned((Eigen::Matrix2Xd(2, 5) << -3, -1.5, 1.5, 4, 3, 0, 1.2, 1.2, 6, 0).finished());
  Points slow_at_first = unturned((Eigen::Matrix2Xd(2, 5) << -3, -4, -1.6, 1.6, 3, 0, -6, 1.2, 1.2, 0).finished());
  slow_at_first.bottomRows(4) *= -1;
  const double least = scene.plans.cost(first);
  PlanRoadmap map(scene.plans, first.col(0), first.rightCols(1), 4);
  map.add_path(slow_at_last);
  map.add_path(slow_at_first);
  const Points way = map.cheapest({});
  REQUIRE(way.cols() > 2);
  CHECK(way.col(0) == first.col(0));
  CHECK(all_move(scene.plans, way));
  CHECK(scene.plans.cost(way) < 1.02 * least);
  CHECK(scene.plans.cost(slow_at_last) > 1.5 * least);
  CHECK(scene.plans.cost(slow_at_first) > 1.5 * least);
  const long asked = map.asked();
  CHECK(map.cheapest({}) == way);
  CHECK(map.asked() == asked);
}

TEST_CASE("plan roadmap: without a way there is none") {
  const BarAtAWall scene;
  const Points ends = unturned((Eigen::Matrix2Xd(2, 2) << -3, 3, 0, 0).finished());
  PlanRoadmap map(scene.plans, ends.col(0), ends.col(1), 10);
  CHECK(map.cheapest({}).cols() == 0);
}

TEST_CASE("plan trees: a plan is clear of the walls, and the same for the same seed") {
  const BarAtAWall scene;
  const Points ends = unturned((Eigen::Matrix2Xd(2, 2) << -3, 3, 0, 0).finished());
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto plan = random_plan(scene.plans, ends.col(0), ends.col(1), seed, 3000, {});
    REQUIRE(plan);
    CHECK(plan->col(0) == ends.col(0));
    CHECK(plan->rightCols(1).cwiseAbs() == ends.col(1).cwiseAbs());
    CHECK(all_move(scene.plans, *plan));
    CHECK(random_plan(scene.plans, ends.col(0), ends.col(1), seed, 3000, {}) == plan);
  }
  CHECK_FALSE(random_plan(scene.plans, ends.col(0), ends.col(1), 1, 3, {}));
}

}  // namespace leastcost::test
