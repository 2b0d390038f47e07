// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/remembering_walls.hpp"

#include <algorithm>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/trials.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Place = Eigen::VectorXd;

std::shared_ptr<const RobotWalls> walls_of_arm(unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> place(-0.8, 0.8), size(0.04, 0.15);
  RobotWalls::Obstacles obstacles;
  for (int i = 0; i < 8; ++i) {
    const Vector3d center = Vector3d::NullaryExpr([&] { return place(engine); }) + Vector3d(0, 0, 0.4);
    const double half = size(engine);
    if (i % 2 == 0)
      obstacles.push_back(make_ball({center, half}));
    else
      obstacles.push_back(make_box_obstacle({center.array() - half, center.array() + half}));
  }
  return std::make_shared<const RobotWalls>(make_dh_arm({}), obstacles, 0.01);
}

std::shared_ptr<const RobotWalls> walls_of_body() {
  Eigen::MatrixXd shape(1, 5);
  shape << -0.3, 0.1, 0.5, 0.2, 0.1;
  return std::make_shared<const RobotWalls>(make_rigid_body({shape}),
                                            RobotWalls::Obstacles{make_ball({Eigen::Vector2d(0.5, 0.5), 0.2})}, 0.01);
}

/// Looks as a solve makes them: a place moves a little, and now and then jumps.
template <class Look>
void look_about(const RobotWalls& walls, const Look& look) {
  std::mt19937 engine(20261206);
  std::normal_distribution<double> step;
  std::uniform_real_distribution<double> unit(0, 1);
  Place x = Place::Zero(walls.dimension());
  for (int k = 0; k < test::trials(1500); ++k) {
    const double length = unit(engine) < 0.03 ? 1 : std::pow(10.0, -4 * unit(engine));
    x += length * Place::NullaryExpr(x.size(), [&] { return 0.2 * step(engine); });
    x = x.cwiseMax(-2).cwiseMin(2);
    look(x, std::pow(10.0, 1 - 6 * unit(engine)), engine);
  }
}

void check_same_walls(const std::vector<Wall>& a, const std::vector<Wall>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].obstacle == b[i].obstacle);
    CHECK(a[i].gap == b[i].gap);
    CHECK(a[i].required == b[i].required);
    CHECK(a[i].slope == b[i].slope);
  }
}

Problem arm_problem(const std::shared_ptr<const Walls>& walls) {
  Problem problem;
  const auto arm = make_dh_arm({});
  problem.manifold = std::make_shared<const FreeSpace>(
      std::make_shared<const EuclideanManifold>(
          EuclideanManifoldOptions{.dimension = 7, .box = {arm->kinematics->lower(), arm->kinematics->upper()}}),
      walls);
  problem.cost = make_euclidean_cost(7);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u.resize(7);
  problem.source.u << -1.2, 0.4, 0, -1.8, 0, 2.2, 0.7;
  problem.target.u.resize(7);
  problem.target.u << 1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5;
  return problem;
}

std::shared_ptr<const Walls> two_balls() {
  return std::make_shared<const RobotWalls>(
      make_dh_arm({}),
      RobotWalls::Obstacles{make_ball({Vector3d(0.55, 0, 0.45), 0.12}), make_ball({Vector3d(0.45, 0.35, 0.95), 0.1})},
      0.02);
}

}  // namespace

TEST_CASE("remembering walls: what is near is what the walls themselves say") {
  for (const auto& walls : {walls_of_arm(1), walls_of_arm(2), walls_of_body()}) {
    const RememberingWalls remembering(walls);
    std::vector<Wall> plain, remembered;
    int some = 0;
    look_about(*walls, [&](const Place& x, double reach, std::mt19937&) {
      walls->near(x, reach, plain);
      remembering.near(x, reach, remembered);
      check_same_walls(plain, remembered);
      some += plain.empty() ? 0 : 1;
    });
    CHECK(some > test::trials(100));
    walls->near(Place::Constant(walls->dimension(), std::nan("")), 1, plain);
    remembering.near(Place::Constant(walls->dimension(), std::nan("")), 1, remembered);
    CHECK(plain.size() == remembered.size());
  }
}

TEST_CASE("remembering walls: along moves they find the same walls, and a room that is one", "[slow]") {
  for (const auto& walls : {walls_of_arm(3), walls_of_body()}) {
    const RememberingWalls remembering(walls);
    std::vector<Wall> plain, remembered;
    int less = 0, some = 0;
    look_about(*walls, [&](const Place& a, double reach, std::mt19937& engine) {
      std::normal_distribution<double> step;
      const Place b = a + Place::NullaryExpr(a.size(), [&] { return 0.03 * step(engine); });
      reach = std::min(reach, 0.5);
      walls->along(a, b, reach, plain);
      remembering.along(a, b, reach, remembered);
      REQUIRE(plain.size() == remembered.size());
      for (std::size_t i = 0; i < plain.size(); ++i) {
        CHECK(plain[i].obstacle == remembered[i].obstacle);
        CHECK(plain[i].gap == Approx(remembered[i].gap).margin(1e-12));
      }
      some += plain.empty() ? 0 : 1;
      // No core is nearer than the room, at places of the move.
      const double room = remembering.room(a, b, reach);
      CHECK(room <= reach);
      for (int k = 0; k <= 4; ++k) {
        walls->near(a + (b - a) * k / 4, reach, plain);
        for (const Wall& wall : plain) CHECK(room <= wall.gap + wall.required + 1e-12);
      }
      less += room < 0.5 * walls->room(a, b, reach) - 1e-9 ? 1 : 0;
    });
    CHECK(some > test::trials(20));
    CHECK(less < 50);  // nor is it much less than the walls themselves know
  }
}

TEST_CASE("remembering walls: whoever did not make them gets the walls themselves") {
  const auto walls = walls_of_arm(4);
  const RememberingWalls remembering(walls);
  std::vector<std::thread> threads;
  std::vector<std::vector<Wall>> found(3);
  const Place x = Place::Constant(7, 0.3);
  for (auto& mine : found) threads.emplace_back([&] { remembering.near(x, 1, mine); });
  for (std::thread& thread : threads) thread.join();
  std::vector<Wall> here;
  remembering.near(x, 1, here);
  CHECK_FALSE(here.empty());
  for (const auto& theirs : found) check_same_walls(here, theirs);
  CHECK(RobotWalls(make_dh_arm({}), {}, 0).remembering() == nullptr);  // nobody shares them
}

TEST_CASE("arms in threads: solves that share walls come to the same paths") {
  const Problem problem = arm_problem(two_balls());
  std::vector<Result> results(2);
  std::vector<std::thread> threads;
  for (Result& result : results)
    threads.emplace_back([&] {
      result = find_path(problem, RrtInitializer(), Newton(), {.points = 24, .certificate = {.enabled = false}});
    });
  for (std::thread& thread : threads) thread.join();
  REQUIRE(results[0].curve.x.size() > 0);
  CHECK(results[0].solve.termination == Termination::converged);
  CHECK(results[0].curve.x == results[1].curve.x);
  const Result again =
      find_path(problem, RrtInitializer(), Newton(), {.points = 24, .certificate = {.enabled = false}});
  CHECK(again.curve.x == results[0].curve.x);  // nor does it matter what was solved before
}

}  // namespace leastcost
