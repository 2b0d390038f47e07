// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Moves of robots, whether they are clear: told quickly, by a sieve. First paths of robots that are made with it.
#include "problems/robots/move_sieve.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include "problems/robots/box_distance.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/trials.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Place = Eigen::VectorXd;

double unit(std::mt19937& engine) { return std::uniform_real_distribution<double>(0, 1)(engine); }

Vector3d in_cube(std::mt19937& engine, double half) {
  return Vector3d::NullaryExpr([&] { return half * (2 * unit(engine) - 1); });
}

RobotWalls::Obstacles things_in_space(std::mt19937& engine) {
  RobotWalls::Obstacles all;
  for (int i = 0; i < 8; ++i) {
    const Vector3d center = in_cube(engine, 0.8) + Vector3d(0, 0, 0.4);
    const Vector3d half = Vector3d::Constant(0.17) + in_cube(engine, 0.13);
    if (i % 4 == 0)
      all.push_back(make_ball({center, half[0]}));
    else if (i % 4 == 1)
      all.push_back(make_box_obstacle({center - half, center + half}));
    else if (i % 4 == 2)
      all.push_back(make_box({.size = 2 * half, .pose = {.position = center, .rotation = in_cube(engine, 3)}}));
    else
      all.push_back(make_cylinder(
          {.radius = half[0], .height = half[1], .pose = {.position = center, .rotation = in_cube(engine, 3)}}));
  }
  all.push_back(make_capsule({.from = Vector3d(0.9, 0, 0), .to = Vector3d(0.9, 0.2, 0.4), .radius = 0.1}));
  all.push_back(make_half_space({.normal = Vector3d(0.1, 0, 1), .offset = -0.4}));
  return all;
}

RobotWalls::Obstacles things_in_plane() {
  Eigen::MatrixXd corners(3, 2);
  corners << 0.3, 0.2, 0.9, 0.3, 0.5, 0.9;
  return {make_ball({Eigen::Vector2d(-0.6, 0.5), 0.2}),
          make_box_obstacle({Eigen::Vector2d(-0.9, -0.9), Eigen::Vector2d(-0.5, -0.3)}), make_polygon({corners})};
}

std::shared_ptr<const RobotWalls> walls_of(int which, std::mt19937& engine) {
  if (which == 0) return std::make_shared<const RobotWalls>(make_dh_arm({}), things_in_space(engine), 0.01);
  if (which == 1)
    return std::make_shared<const RobotWalls>(make_dh_arm({.model = arm_model::Ur5{}}), things_in_space(engine), 0);
  Eigen::MatrixXd shape(2, 5);
  shape << -0.1, 0.05, 0.2, 0.1, 0.03,  //
      0.2, 0.1, 0.2, 0.1, 0.06;
  return std::make_shared<const RobotWalls>(make_rigid_body({shape}), things_in_plane(), 0.01);
}

Place somewhere(const Walls& walls, std::mt19937& engine) {
  return Place::NullaryExpr(walls.dimension(),
                            [&] { return 2.5 * (2 * unit(engine) - 1) * (walls.dimension() > 3 ? 1 : 0.4); });
}

double least_gap(const Walls& walls, const Place& x) {
  std::vector<Wall> found;
  walls.near(x, 0.1, found);
  double least = std::numeric_limits<double>::infinity();
  for (const Wall& wall : found) least = std::min(least, wall.gap);
  return least;
}

/// Two joints and a bar, in a plane that a wall crosses with a slot in it.
Problem through_slot(double slot) {
  arm_model::Table table;
  table.rows = Eigen::MatrixXd::Zero(3, 4);
  table.rows.col(0).setConstant(0.5);
  table.lower = Place::Constant(3, -3);
  table.upper = Place::Constant(3, 3);
  table.shape = Eigen::MatrixXd(3, 8);
  table.shape << 1, -0.5, 0, 0, 0, 0, 0, 0.02,  //
      2, -0.5, 0, 0, 0, 0, 0, 0.02,             //
      3, -0.5, 0, 0, 0, 0, 0, 0.02;
  table.self = Eigen::MatrixXd(1, 2);
  *table.self << 0, 2;
  const std::shared_ptr<const Robot> robot = make_dh_arm({.model = table});
  const auto part = [](double from, double to) {
    return make_box_obstacle({Vector3d(0.6, from, -1), Vector3d(0.65, to, 1)});
  };
  const RobotWalls::Obstacles wall = {part(-2, -slot / 2), part(slot / 2, 2)};
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(
      std::make_shared<const EuclideanManifold>(
          EuclideanManifoldOptions{.dimension = 3, .box = {robot->kinematics->lower(), robot->kinematics->upper()}}),
      std::make_shared<const RobotWalls>(robot, wall, 0.001));
  problem.source.u = Vector3d(2, 0.5, 0.5);  // behind the wall
  problem.target.u = Vector3d(0, 0, 0);      // through the slot
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Expm1Square>();
  return problem;
}

}  // namespace

TEST_CASE("distance of a segment to a box: the least over its places") {
  std::mt19937 engine(20261127);
  for (int k = 0; k < test::trials(500); ++k) {
    const Vector3d half = in_cube(engine, 1).cwiseAbs(), a = in_cube(engine, 2);
    const Vector3d way = k % 5 == 0 ? Vector3d(2, 0, 0) : Vector3d(in_cube(engine, 2));
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 200; ++i) least = std::min(least, distance_to_box(a + way * i / 200, half));
    const double found = distance_to_box(a, way, half);
    CHECK(found <= least + 1e-12);
    CHECK(found >= least - way.norm() / 400);
  }
  CHECK(distance_to_box(Vector3d(2, 0, 0), Vector3d::Zero(), Vector3d(1, 1, 1)) == Approx(1));
  CHECK(distance_to_box(Vector3d(-2, 0, 0), Vector3d(4, 0, 0), Vector3d(1, 1, 1)) == 0);
}

TEST_CASE("robot walls: what is told quickly of a move is what its clearance says") {
  for (int which = 0; which < 3; ++which) {
    std::mt19937 engine(static_cast<unsigned>(71 + which));
    const auto walls = walls_of(which, engine);
    int clear = 0, touching = 0;
    for (int k = 0; k < test::trials(300); ++k) {
      const Place a = somewhere(*walls, engine);
      const Place b = a + (somewhere(*walls, engine) - a) * std::pow(unit(engine), 2);
      const MoveClearance least = walls->clearance(a, b);
      INFO("robot " << which << ", move " << k << ": " << least.lower << " to " << least.upper);
      if (least.lower > 1e-9) {
        CHECK(walls->clears(a, b));
        ++clear;
      } else if (least.upper < -1e-9) {
        CHECK_FALSE(walls->clears(a, b));
        ++touching;
      }
    }
    CHECK(clear > 20);
    CHECK(touching > 20);
  }
}

TEST_CASE("move sieve: what does not pass touches and nothing touches outside of what is left") {
  for (int which = 0; which < 3; ++which) {
    std::mt19937 engine(static_cast<unsigned>(91 + which));
    const auto walls = walls_of(which, engine);
    // Without a clearance: sieves take what is required.
    const RobotWalls::Obstacles things = which < 2 ? things_in_space(engine) : things_in_plane();
    std::vector<double> required;
    for (const auto& thing : things) required.push_back(thing->radius());
    Eigen::MatrixXd shape(1, 5);
    shape << -0.1, 0.05, 0.2, 0.1, 0.03;
    const std::shared_ptr<const Robot> robot = which == 0   ? make_dh_arm({})
                                               : which == 1 ? make_dh_arm({.model = arm_model::Ur5{}})
                                                            : make_rigid_body({shape});
    const RobotWalls reference(robot, things, 0);
    const MoveSieve sieve(robot, things, required);
    int passed = 0;
    MoveSieve::Pieces left;
    for (int k = 0; k < test::trials(100); ++k) {
      const Place a = somewhere(*walls, engine);
      const Place b = a + 0.1 * (somewhere(*walls, engine) - a);
      const bool passes = sieve.passes(a, b, 1e-12, 0.05, left);
      passed += passes ? 1 : 0;
      bool touches = false;
      for (int i = 0; i <= 256; ++i) {  // also the places that the sieve has looked at
        const double t = i / 256.0, gap = least_gap(reference, a + t * (b - a));
        touches = touches || gap < 0;
        if (passes && gap < -1e-9)
          CHECK(std::any_of(left.begin(), left.end(),
                            [&](const auto& piece) { return piece.first <= t && t <= piece.second; }));
      }
      if (!passes) CHECK(touches);
    }
    CHECK(passed > 5);
  }
}

/// Beyond 64 obstacles a tree of them is asked; halves of them are few enough to be looked at one by one.
// An end of an endless joint may be a billion radians away: what would take hours to look at is not clear.
TEST_CASE("move sieve: a move of more turns than can be looked at does not pass") {
  const RobotWalls::Obstacles things = {make_ball({Vector3d(0, 0, 1.5), 0.2})};
  const MoveSieve sieve(make_dh_arm({}), things, {things[0]->radius()});
  Place a(7);
  a << 0, -0.785, 0, -2.356, 0, 1.571, 0.785;
  const auto passes = [&](double turn) {
    MoveSieve::Pieces left;
    return sieve.passes(a, a + turn * Place::Unit(7, 0), 1e-12, 0.05, left);
  };
  CHECK(passes(100));
  CHECK_FALSE(passes(1e9));
}

TEST_CASE("robot walls: among many obstacles what is near is what is near among their halves") {
  for (int which = 0; which < 2; ++which) {
    std::mt19937 engine(static_cast<unsigned>(31 + which));
    RobotWalls::Obstacles all;
    if (which == 1) all.push_back(make_half_space({Vector3d(0, 0, 1), -0.3}));
    while (all.size() < 110) {
      const Vector3d center = in_cube(engine, 1.2) + Vector3d(0, 0, 0.4), half = Vector3d(0.03, 0.02, 0.04);
      if (all.size() % 2 == 0)
        all.push_back(make_box_obstacle({center - half, center + half}));
      else
        all.push_back(make_box({.size = 2 * half, .pose = {.position = center, .rotation = in_cube(engine, 3)}}));
    }
    const std::shared_ptr<const Robot> robot = make_dh_arm({});
    const RobotWalls many(robot, all, 0.01);
    const RobotWalls first(robot, {all.begin(), all.begin() + 55}, 0.01),
        second(robot, {all.begin() + 55, all.end()}, 0.01);
    int clear = 0, touching = 0;
    for (int k = 0; k < test::trials(150); ++k) {
      const Place a = somewhere(many, engine), b = a + 0.3 * unit(engine) * (somewhere(many, engine) - a);
      const bool clears = first.clears(a, b) && second.clears(a, b);
      CHECK(many.clears(a, b) == clears);
      (clears ? clear : touching) += 1;
      const MoveClearance one = first.clearance(a, b), other = second.clearance(a, b), both = many.clearance(a, b);
      CHECK(both.lower <= std::min(one.upper, other.upper) + 1e-9);
      CHECK(both.upper >= std::min(one.lower, other.lower) - 1e-9);
      std::vector<Wall> near, near_first, near_second;
      many.near(a, 0.05, near);
      first.near(a, 0.05, near_first);
      second.near(a, 0.05, near_second);
      const std::size_t self = std::count_if(near_first.begin(), near_first.end(), [&](const Wall& wall) {
        return wall.obstacle >= static_cast<int>(robot->parts() * 55);
      });
      CHECK(near.size() == near_first.size() + near_second.size() - self);
    }
    CHECK(clear > 10);
    CHECK(touching > 10);
  }
}

TEST_CASE("robot walls: numbers that are none are not clear") {
  std::mt19937 engine(1);
  const auto walls = walls_of(0, engine);
  const Place here = Place::Zero(7), nowhere = Place::Constant(7, std::numeric_limits<double>::quiet_NaN());
  CHECK_FALSE(walls->clears(here, nowhere));
  CHECK_FALSE(walls->clears(Place::Constant(7, std::numeric_limits<double>::infinity()), here));
}

TEST_CASE("rrt: first paths of a robot are proved to be clear and the same for a seed") {
  for (const double slot : {0.5, 0.4}) {
    const Problem problem = through_slot(slot);
    for (int seed = 1; seed <= test::trials(4); ++seed) {
      INFO("slot " << slot << ", seed " << seed);
      const FirstPath first = RrtInitializer({.seed = seed}).first_path(problem, {});
      CHECK(first.path.u.leftCols(1) == problem.source.u);
      CHECK(first.path.u.rightCols(1) == problem.target.u);
      const auto clearance = measure_clearance(*problem.manifold, first.path.u, false, {});
      REQUIRE(clearance);
      CHECK(clearance->proved);
      CHECK(clearance->lower > -1e-9);
      CHECK(RrtInitializer({.seed = seed}).first_path(problem, {}).path.u == first.path.u);
    }
  }
}

TEST_CASE("rrt: a robot finds its way from a place where it is in contact") {
  Problem problem = through_slot(0.5);
  const auto& walls = *find_ability<DecidesMoves>(*problem.manifold);
  double clear = 0, touching = 0.6;  // of a turn of the first joint from the slot against its side
  for (int k = 0; k < 60; ++k) {
    const double middle = (clear + touching) / 2;
    (walls.clears(Vector3d(middle, 0, 0), Vector3d(middle, 0, 0)) ? clear : touching) = middle;
  }
  problem.target.u = Vector3d(clear, 0, 0);
  REQUIRE(walls.clears(problem.target.u, problem.target.u));
  const FirstPath first = RrtInitializer({.seed = 1}).first_path(problem, {});
  CHECK(measure_clearance(*problem.manifold, first.path.u, false, {})->lower > -1e-9);
}

TEST_CASE("rrt: a robot that no way leads out for says so within its nodes") {
  const Problem problem = through_slot(0.045);  // the bar fits in, nothing else
  CHECK_THROWS_WITH(RrtInitializer({.max_nodes = 300, .seed = 1}).first_path(problem, {}),
                    Catch::Contains("rrt: no path after 300 nodes"));
}

}  // namespace leastcost
