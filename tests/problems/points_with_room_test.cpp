// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// How many points a robot's path gets where their number is left to the search.
#include <memory>
#include <optional>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

/// A disc of radius 0.01 goes 40 along a corridor that leaves its centre `room` on either side.
Problem corridor(double room) {
  Eigen::MatrixXd disc(1, 5);
  disc << 0, 0, 0, 0, 0.01;
  const double half = 0.01 + room;
  const RobotWalls::Obstacles sides = {
      make_box_obstacle({.lower = Eigen::Vector2d(1, half), .upper = Eigen::Vector2d(39, 2)}),
      make_box_obstacle({.lower = Eigen::Vector2d(1, -2), .upper = Eigen::Vector2d(39, -half)})};
  const auto space = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3});
  const auto walls = std::make_shared<const RobotWalls>(make_rigid_body({disc}), sides, 0);
  return {std::make_shared<FreeSpace>(space, walls),
          make_euclidean_cost(3),
          make_kernel<Expm1Square>(),
          {Eigen::Vector3d(0, 0, 0), kNoSite},
          {Eigen::Vector3d(40, 0, 0), kNoSite}};
}

long points_of(double room, std::optional<int> points) {
  FindOptions options;
  options.points = points;
  options.certificate.enabled = false;
  return find_path(corridor(room), StraightInitializer(), Newton(), options).initial.free_count();
}

}  // namespace

TEST_CASE("points of a robot's path: as many as have room between walls") {
  CHECK(points_of(0.2, std::nullopt) == 200);
  CHECK(points_of(0.05, std::nullopt) == 400);  // moves of 0.1 keep 0.0525 from a core, which is 0.01 inside the disc
  CHECK(points_of(0.02, std::nullopt) == 800);
}

}  // namespace leastcost
