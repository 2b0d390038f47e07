// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/ompl/ompl_initializer.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/manifolds/pose.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "tests/contracts/initializer_contract.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/choices.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

constexpr OmplPlanner kLastPlanner = OmplPlanner::bit_star;
constexpr double kTouch = 1e-12;  ///< length units

template <class Options>
concept TakesMisspeltPlanner = requires {
  Options{.planner = "RRTConect"};
};
static_assert(!TakesMisspeltPlanner<OmplOptions>);
static_assert(!kTakesWords<decltype(OmplOptions::planner)>);

/// A wall across a square, with a gate of width 0.5 at its upper end.
Problem behind_a_wall() {
  const auto square = std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions{.dimension = 2, .box = {Eigen::Vector2d(-1, -1), Eigen::Vector2d(2, 2)}});
  const FreeSpace::Obstacles wall{make_box_obstacle({Eigen::Vector2d(0.4, -2), Eigen::Vector2d(0.6, 1.5)})};
  return between(std::make_shared<const FreeSpace>(square, wall, 0.05), make_euclidean_cost(2), Eigen::Vector2d(0, 0),
                 Eigen::Vector2d(1, 0));
}

/// An arm whose straight way meets two balls.
Problem arm_among_balls() {
  const auto arm = make_dh_arm({});
  const auto walls =
      std::make_shared<const RobotWalls>(arm,
                                         RobotWalls::Obstacles{make_ball({Eigen::Vector3d(0.55, 0, 0.45), 0.12}),
                                                               make_ball({Eigen::Vector3d(0.45, 0.35, 0.95), 0.1})},
                                         0.02);
  const auto joints = std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions{.dimension = 7, .box = {arm->kinematics->lower(), arm->kinematics->upper()}});
  Eigen::VectorXd source(7), target(7);
  source << -1.2, 0.4, 0, -1.8, 0, 2.2, 0.7;
  target << 1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5;
  return between(std::make_shared<const FreeSpace>(joints, walls), make_euclidean_cost(7), source, target);
}

Problem pose_behind_a_ball() {
  const auto poses = make_spatial_poses({{Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(2, 1, 1)}});
  const FreeSpace::Obstacles ball{make_ball({Eigen::Vector3d(0.5, 0, 0), 0.3})};
  Eigen::VectorXd source(7), target(7);
  source << 0, 0, 0, 1, 0, 0, 0;
  target << 1, 0, 0, std::cos(1.0), std::sin(1.0), 0, 0;
  return between(std::make_shared<const FreeSpace>(poses, ball, 0.02),
                 make_weighted_length({Eigen::Vector2d(1, 0.5)}, *poses), source, target);
}

/// How far the moves of a path stay from the obstacles.
double clearance_of(const Problem& problem, const CoordinatePath& path) {
  const auto found = measure_clearance(*problem.manifold, path.u, false, {});
  return found ? found->lower : std::numeric_limits<double>::infinity();
}

/// Of a planner that may go on improving its path until its time is up: within the least time that suffices for one.
/// What a busy machine does in a tenth of a second nobody knows.
FirstPath path_of(OmplPlanner planner, const Problem& problem) {
  constexpr double kLongest = 20;
  const bool improves = planner >= OmplPlanner::prm_star;
  for (double seconds = improves ? 0.3 : kLongest;; seconds *= 2) {
    try {
      return OmplInitializer({.planner = planner, .max_seconds = seconds, .seed = 5}).first_path(problem, {});
    } catch (const InitializationError&) {
      if (seconds >= kLongest) throw;
    }
  }
}

std::string refusal(const OmplInitializer& initializer, const Problem& problem) {
  try {
    initializer.first_path(problem, {});
  } catch (const InitializationError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("typed options: every planner of ompl has one word") { check_words(kLastPlanner); }

TEST_CASE("initializer contract: ompl", "[contract]") {
  const auto sphere = make_implicit_manifold({.surface = implicit::Sphere{}});
  const Eigen::Vector3d x(1, 0, 0);
  check_initializer_contract(OmplInitializer(), behind_a_wall());
  check_initializer_contract(OmplInitializer(), arm_among_balls());
  check_initializer_contract(OmplInitializer(), pose_behind_a_ball());
  check_initializer_contract(OmplInitializer(), between(sphere, make_euclidean_cost(3), x, -x));
  check_initializer_contract(
      OmplInitializer(), between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1e-8, 0)));
}

TEST_CASE("ompl: every planner goes through the gate of a wall, and no move of its path touches") {
  const Problem problem = behind_a_wall();
  for (int i = 0; i <= static_cast<int>(kLastPlanner); ++i) {
    const auto planner = static_cast<OmplPlanner>(i);
    CAPTURE(word_of(planner));
    const FirstPath first = path_of(planner, problem);
    CHECK(clearance_of(problem, first.path) >= -kTouch);
    CHECK(first.path.u.row(1).maxCoeff() >= 1.55 - kTouch);  // through the gate
    REQUIRE(first.notes.size() == 1);
    CHECK_THAT(first.notes[0], Catch::Contains(std::string(word_of(planner))));
  }
}

TEST_CASE("ompl: configurations and poses of its path are clear of what they must not touch") {
  for (const Problem& problem : {arm_among_balls(), pose_behind_a_ball()}) {
    REQUIRE(measure_clearance(*problem.manifold,
                              (Points(problem.source.u.size(), 2) << problem.source.u, problem.target.u).finished(),
                              false, {})
                ->upper < 0);
    for (const OmplPlanner planner : {OmplPlanner::rrt_connect, OmplPlanner::kpiece, OmplPlanner::prm}) {
      CAPTURE(word_of(planner));
      const FirstPath first = OmplInitializer({.planner = planner, .seed = 7}).first_path(problem, {});
      CHECK(clearance_of(problem, first.path) >= -kTouch);
      CHECK(problem.manifold->residual(first.path) <= 1e-14);
    }
  }
}

TEST_CASE("ompl: seeds give paths, the same ones in threads") {
  const Problem problem = behind_a_wall();
  const auto path = [&](int seed) {
    return OmplInitializer({.shortcuts = 0, .seed = seed}).first_path(problem, {}).path.u;
  };
  const Points once = path(1);
  CHECK_FALSE((path(2).cols() == once.cols() && path(2) == once));
  CHECK(OmplInitializer({.shortcuts = 0}, 1).first_path(problem, {}).path.u == once);  // the seed of the run
  std::vector<Points> found(3);
  std::vector<std::thread> threads;
  for (Points& mine : found) threads.emplace_back([&] { mine = path(1); });
  for (std::thread& thread : threads) thread.join();
  for (const Points& mine : found) CHECK((mine.cols() == once.cols() && mine == once));
}

TEST_CASE("ompl: what cannot be planned is refused in words") {
  // Found by random problems: the box of samples is infinite.
  const Problem far = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1e300, 1));
  CHECK_THAT(refusal(OmplInitializer(), far), Catch::Contains("bound the domain"));
  const auto plane = make_euclidean_cost(2), in_space = make_euclidean_cost(3);
  const OmplInitializer ompl({.max_seconds = 0.2});
  Problem shut = behind_a_wall();
  const FreeSpace::Obstacles wall{make_box_obstacle({Eigen::Vector2d(0.4, -2), Eigen::Vector2d(0.6, 3)})};
  shut.manifold =
      std::make_shared<const FreeSpace>(std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{
                                            .dimension = 2, .box = {Eigen::Vector2d(-1, -1), Eigen::Vector2d(2, 2)}}),
                                        wall, 0.05);
  CHECK_THAT(refusal(ompl, shut), Catch::Contains("no path; RRTConnect came to") && Catch::Contains("0.2 s"));
  CHECK_THAT(refusal(OmplInitializer({.planner = OmplPlanner::fmt, .max_seconds = 0.2}), shut),
             Catch::Contains("no path; FMT came to"));
  CHECK_THAT(refusal(ompl, closed(space(2), plane)), Catch::Contains("ring"));
  CHECK_THAT(refusal(ompl, between(std::make_shared<const MeshManifold>(TriangleMesh(cube())), in_space,
                                   Eigen::Vector3d(0.5, 0, 0), Eigen::Vector3d(-0.5, 0, 0))),
             Catch::Contains("dijkstra"));
  CHECK_THAT(refusal(ompl, closed(make_parametric_manifold({.surface = parametric::Torus{}}), in_space)),
             Catch::Contains("ring"));
  const double nothing = std::nan("");
  CHECK_THROWS_AS(OmplInitializer({.max_seconds = 0}), OptionError);
  CHECK_THROWS_AS(OmplInitializer({.max_seconds = nothing}), OptionError);
  CHECK_THROWS_AS(OmplInitializer({.range = -1}), OptionError);
  CHECK_THROWS_AS(OmplInitializer({.step = nothing}), OptionError);
  CHECK_THROWS_WITH(OmplInitializer({.planner = OmplPlanner::prm, .range = 1}), Catch::Contains("PRM has none"));
  Monitor stop;
  stop.stop_requested = [] { return true; };
  CHECK_THROWS_AS(ompl.first_path(shut, stop), Interrupted);
}

}  // namespace leastcost::test
