// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/grid_obstacle.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/solvers/newton.hpp>
#include "problems/distance/grid_bounds.hpp"
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.6;

/// A ball around the origin, in a box that ends `margin` beyond it.
DistanceGrid ball_grid(double cell, double margin = 0.4) {
  const int count = static_cast<int>(std::ceil(2 * (kRadius + margin) / cell)) + 1;
  const GridShape shape{Vector3d::Constant(-(count - 1) * cell / 2), cell, {count, count, count}};
  std::vector<double> values;
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) values.push_back(shape.node(i, j, k).norm() - kRadius);
  return DistanceGrid(shape, values);
}

Vector3d random_place(std::mt19937& engine, double size) {
  std::uniform_real_distribution<double> number(-size, size);
  return {number(engine), number(engine), number(engine)};
}

}  // namespace

TEST_CASE("distance grids: nothing is steeper or more bent than their bounds, nor lower on the border") {
  const DistanceGrid grid = ball_grid(0.1);
  constexpr double kFrom = -0.2;
  const GridBounds bounds = bounds_above(grid, kFrom);
  const double border = least_on_border(grid);
  CHECK(bounds.slope < 1.1);  // of a ball that is large beside the cells
  CHECK(bounds.bend < 8);     // 2.5 at the depth of two cells
  CHECK(border == Approx(0.4).margin(0.01));
  std::mt19937 engine(2);
  const double inner = grid.shape().upper().x() - 0.01;
  Vector3d slope, ahead, unused;
  double steepest = 0, most_bent = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vector3d x = random_place(engine, inner), way = random_place(engine, 1).normalized();
    if (grid.evaluate(x, slope) < kFrom) continue;
    constexpr double kStep = 1e-4;
    const double bend =
        (grid.evaluate(x + kStep * way, ahead) - 2 * grid.evaluate(x, slope) + grid.evaluate(x - kStep * way, unused)) /
        (kStep * kStep);
    steepest = std::max(steepest, slope.norm());
    most_bent = std::max(most_bent, bend);
    CHECK(slope.norm() <= bounds.slope + 1e-12);
    CHECK(bend <= bounds.bend + 1e-5);
    Vector3d side = x;
    side[k % 3] = k % 2 == 0 ? grid.shape().origin[k % 3] : grid.shape().upper()[k % 3];
    CHECK(grid.evaluate(side, unused) >= border - 1e-12);
  }
  CHECK(bounds.slope < 1.1 * steepest);  // they say something
  CHECK(bounds.bend < 5 * most_bent);
}

TEST_CASE("grid obstacles: never farther than the ball that was sampled, and nearly as far beside it",
          "[slow_sanitized]") {
  const DistanceGrid grid = ball_grid(0.05);
  const double slope = bounds_above(grid, -0.025).slope;
  const auto obstacle = make_grid_obstacle(grid, 0, "the ball");
  std::mt19937 engine(3);
  Eigen::VectorXd away(3);
  // The surface of the spline is this far from the ball, at most: of order 4 in the cell.
  constexpr double kOfSpline = 2e-5;
  for (int k = 0; k < 1000; ++k) {
    const Vector3d x = random_place(engine, k % 2 == 0 ? 0.9 : 4), y = random_place(engine, 0.9);
    const double truth = x.norm() - kRadius, found = obstacle->distance(x, away);
    CAPTURE(k, x.transpose(), truth, found);
    CHECK(found <= std::max(truth, 0.0) + kOfSpline);
    if (truth > 0 && k % 2 == 0) CHECK(found >= truth / slope - kOfSpline);
    Eigen::VectorXd there(3);
    CHECK(std::abs(obstacle->distance(y, there) - found) <= (x - y).norm() + 1e-12);
    double t = 0;
    const double of_segment = obstacle->distance_of_segment(x, y, t);
    const double nearest = std::clamp(-x.dot(y - x) / (y - x).squaredNorm(), 0.0, 1.0);
    CHECK(of_segment <= std::max(0.0, (x + nearest * (y - x)).norm() - kRadius) + kOfSpline);
  }
}

/// A move that is tangent to the ball with the clearance, and one that grazes it a thousandth nearer.
TEST_CASE("grid obstacles: clearances are proved to their slope") {
  const DistanceGrid grid = ball_grid(0.05);
  const double slope = bounds_above(grid, -0.025).slope, clearance = 0.1, far = kRadius + clearance * slope;
  const ObstacleWalls walls(3, {make_grid_obstacle(grid, 0, "the ball")}, clearance);
  const MoveClearance beyond = walls.clearance(Vector3d(-2, far + 1e-3, 0), Vector3d(2, far + 1e-3, 0));
  CHECK(beyond.lower > 0);
  CHECK(beyond.lower < 2e-3);
  CHECK(walls.clearance(Vector3d(-2, kRadius + 0.099, 0), Vector3d(2, kRadius + 0.099, 0)).upper < 0);
}

/// The last node of a box may lie beyond it by rounding ((0.6 + 0.6) / 0.1 > 12): places there have a distance, too.
TEST_CASE("grid obstacles: beyond the border, and on it, places are as far as they are") {
  constexpr int kCount = 13;
  const GridShape shape{Vector3d::Constant(-0.6), 0.1, {kCount, kCount, kCount}};
  std::vector<double> values;
  for (int k = 0; k < kCount; ++k)
    for (int j = 0; j < kCount; ++j)
      for (int i = 0; i < kCount; ++i) values.push_back(shape.node(i, j, k).norm() - 0.3);
  const auto obstacle = make_grid_obstacle(DistanceGrid(shape, values), 0, "the ball");
  Eigen::VectorXd away(3);
  for (const double y : {0.6 - 1e-12, 0.6, 0.6 + 1e-12, 0.61, 0.7})
    for (const double z : {-0.6, 0.0, 0.6}) {
      const Vector3d x(0.1, y, z);
      CAPTURE(x.transpose());
      const double truth = x.norm() - 0.3, found = obstacle->distance(x, away);
      CHECK(found <= truth + 1e-4);
      CHECK(found >= 0.7 * truth);  // beyond it it is the root of two squares
      CHECK(away.dot(x) > 0);
    }
}

/// Two tangents and an arc around the ball that was sampled, with the clearance as large as the slope makes it.
TEST_CASE("grid obstacles: a path around a ball is the one around the ball, certified and proved") {
  const DistanceGrid grid = ball_grid(0.1);
  constexpr double kClearance = 0.1;
  const double keeps = kRadius + kClearance * bounds_above(grid, -0.05).slope;
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(
      std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3}),
      FreeSpace::Obstacles{make_grid_obstacle(grid, 0, "the ball")}, kClearance);
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Vector3d(-1.5, 0.1, 0.05);
  problem.target.u = Vector3d(1.4, 0, 0);
  const Result result = find_path(problem, RrtInitializer(), Newton(), {.points = 60});
  CHECK(result.status == Status::certified);
  REQUIRE(result.certificate.clearance);
  CHECK(result.certificate.clearance->proved);
  const double a = problem.source.u.norm(), b = problem.target.u.norm();
  const double angle = std::acos(problem.source.u.dot(problem.target.u) / (a * b));
  const auto tangent = [&](double d) { return std::sqrt(d * d - keeps * keeps); };
  const double shortest = tangent(a) + tangent(b) + keeps * (angle - std::acos(keeps / a) - std::acos(keeps / b));
  CHECK(result.curve.cost == Approx(shortest).epsilon(2e-3));  // the sampled ball is round to that
  for (Index i = 0; i < result.curve.x.cols(); ++i) CHECK(result.curve.x.col(i).norm() >= kRadius + kClearance - 1e-3);
}

TEST_CASE("grid obstacles: grids that are none are refused in words") {
  CHECK_THROWS_WITH(make_grid_obstacle(ball_grid(0.1, -0.1), 0, "the grid a.sdf"),
                    Catch::Contains("the grid a.sdf") && Catch::Contains("wider margin"));
  CHECK_THROWS_AS(make_grid_obstacle(ball_grid(0.1), -1, "a"), OptionError);
  CHECK_THROWS_AS(make_grid_obstacle(ball_grid(0.1), std::numeric_limits<double>::quiet_NaN(), "a"), OptionError);
  const GridShape shape{Vector3d::Zero(), 0.1, {5, 5, 5}};
  CHECK_THROWS_WITH(make_grid_obstacle(DistanceGrid(shape, std::vector<double>(125, -1.0)), 0, "a"),
                    Catch::Contains("more than half a cell inside"));
}

}  // namespace leastcost
