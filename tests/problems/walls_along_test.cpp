// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Walls along a move: their slopes against differences of their gaps; and chains that are moved part by part, as they
// are under a time budget, against chains that are moved as a whole.
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/checker_walls.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "framework/domain/in_parts.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

using Eigen::VectorXd;

/// Of one wall; nothing where it is not beside the move.
double gap_of(const Walls& walls, int obstacle, const VectorXd& a, const VectorXd& b) {
  std::vector<Wall> found;
  walls.along(a, b, 10, found);
  for (const Wall& wall : found)
    if (wall.obstacle == obstacle) return wall.gap;
  return std::nan("");
}

/// How many slopes agreed with differences, of how many.
std::pair<int, int> agreeing(const Walls& walls, double range, unsigned seed) {
  constexpr double kStep = 1e-5, kNear = 1e-3;
  test::Random random(seed);
  const auto place = [&] {
    return VectorXd(VectorXd::NullaryExpr(walls.dimension(), [&] { return random.uniform(-range, range); }));
  };
  std::pair<int, int> agreed = {0, 0};
  std::vector<Wall> found;
  for (int k = 0; k < 40; ++k) {
    const VectorXd a = place(), b = a + 0.2 * place(), da = place().normalized(), db = place().normalized();
    walls.along(a, b, 10, found);
    for (const Wall& wall : found) {
      const double ahead = gap_of(walls, wall.obstacle, a + kStep * da, b + kStep * db);
      const double behind = gap_of(walls, wall.obstacle, a - kStep * da, b - kStep * db);
      if (!(wall.gap > 0) || !std::isfinite(ahead) || !std::isfinite(behind)) continue;
      const double expected = wall.slope.dot((1 - wall.at) * da + wall.at * db);
      ++agreed.second;
      agreed.first += std::abs((ahead - behind) / (2 * kStep) - expected) < kNear ? 1 : 0;
    }
  }
  return agreed;
}

CoordinatePath chain_of(const Points& x) { return {x, {}, false}; }

Points retracted(const FreeSpace& space, const Points& x, const Points& step, bool in_parts) {
  Deadline deadline;
  if (in_parts) deadline = std::chrono::steady_clock::now() + std::chrono::hours(1);
  CoordinatePath to;
  retract(space, chain_of(x), step, to, deadline);
  return to.u;
}

}  // namespace

TEST_CASE("walls along a move: slopes are derivatives of the gaps by the ends", "[slow_sanitized]") {
  const std::vector<std::shared_ptr<const Obstacle>> things = {
      make_ball({.center = Eigen::Vector3d(0.4, 0.3, 0.5), .radius = 0.1}),
      make_box_obstacle({Eigen::Vector3d(-0.6, 0.2, 0.1), Eigen::Vector3d(-0.4, 0.5, 0.6)})};
  const auto none_but_kinks = [](const Walls& walls, double range, unsigned seed) {
    const auto [agreed, all] = agreeing(walls, range, seed);
    CAPTURE(agreed, all);
    CHECK(all > 20);
    CHECK(agreed >= all * 9 / 10);  // between two features of a box, or of the move, there is no derivative
  };
  none_but_kinks(ObstacleWalls(3, things, 0.05), 1, 1);
  none_but_kinks(*std::make_shared<const RobotWalls>(make_dh_arm({}), things, 0.01), 1.5, 2);
  const auto distance = [](const VectorXd& x) { return x.norm() - 1; };
  none_but_kinks(
      *make_checker_walls(2, DistanceChecker{.distance = distance, .curvature = 1, .curvature_from = -0.1, .size = 2}),
      3, 3);
}

TEST_CASE("free space: a move between two parts of a chain is not drawn through a core either") {
  const auto plane = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  constexpr Index kColumns = 42;
  for (Index gap = 1; gap + 2 < kColumns; ++gap) {  // parts have 16 columns: 16 | 17 and 32 | 33 among them
    const double middle = 0.1 * (static_cast<double>(gap) + 0.5);
    const FreeSpace space(plane, {make_ball({.center = Eigen::Vector2d(middle, 0), .radius = 0.01})}, 0);
    Points x(2, kColumns);
    for (Index i = 0; i < kColumns; ++i) x.col(i) << 0.1 * static_cast<double>(i), 0.1;
    const Points step = Eigen::Vector2d(0, -0.2).replicate(1, kColumns - 2);
    for (const bool in_parts : {false, true}) {
      const Points to = retracted(space, x, step, in_parts);
      CAPTURE(gap, in_parts);
      CHECK((to(1, gap) + to(1, gap + 1)) / 2 > 0);
    }
  }
}

TEST_CASE("free space: a stop is heard in the midst of a projection") {
  const auto plane = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  const FreeSpace space(plane, {make_ball({.center = Eigen::Vector2d(0, 0), .radius = 1})}, 0);
  constexpr Index kMany = 100'000;  // some 10 ms
  int asked = 0;
  Monitor monitor;
  monitor.stop_requested = [&] { return ++asked > 0; };
  CoordinatePath path{Points::Constant(2, kMany, 0.5), {}, false};
  CHECK_THROWS_AS(project(space, path, monitor.limit()), Interrupted);
  CHECK(asked == 1);
  CHECK((path.u.rightCols(kMany / 2).array() == 0.5).all());
  monitor.stop_requested = [] { return false; };
  const CoordinatePath inside{Points::Constant(2, 20, 0.5), {}, false};
  CoordinatePath parts = inside, whole = inside;
  project(space, parts, monitor.limit());
  space.project(whole);
  CHECK(parts.u == whole.u);
  CHECK(whole.u != inside.u);
}

TEST_CASE("free space: parts of a chain go where the whole goes") {
  const auto plane = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  const FreeSpace space(plane, {make_ball({.center = Eigen::Vector2d(0, 0), .radius = 1})}, 0);
  constexpr Index kColumns = 60;
  Points x(2, kColumns), step(2, kColumns - 2);
  for (Index i = 0; i < kColumns; ++i) {
    const double angle = 1.5 * std::numbers::pi * static_cast<double>(i) / (kColumns - 1);
    x.col(i) = 1.3 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  test::Random random(4);
  for (Index i = 0; i < step.cols(); ++i) step.col(i) << random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4);
  CHECK(retracted(space, x, step, true) == retracted(space, x, step, false));
}

}  // namespace leastcost
