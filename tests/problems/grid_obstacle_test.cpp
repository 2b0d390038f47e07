// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/grid_obstacle.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
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
  const GridBounds bounds = grid.bounds(kFrom);
  const double border = grid.least_on_border();
  CHECK(bounds.slope < 1.1);  // of a ball that is large beside the cells
  CHECK(bounds.bend < 8);     // 2.5 at the depth of two cells, of which the largest entries of the Hessian add up
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

TEST_CASE("grid obstacles: never farther than the ball that was sampled, and nearly as far beside it") {
  const DistanceGrid grid = ball_grid(0.05);
  const double slope = grid.bounds(-0.1).slope;
  const auto obstacle = make_grid_obstacle(grid, 0, "the ball");
  std::mt19937 engine(3);
  Eigen::VectorXd away(3);
  // The surface of the spline is this far from the ball, at most: of order 4 in the cell.
  constexpr double kOfSpline = 2e-5;
  for (int k = 0; k < 3000; ++k) {
    const Vector3d x = random_place(engine, k % 2 == 0 ? 0.9 : 4), y = random_place(engine, 0.9);
    const double truth = x.norm() - kRadius, found = obstacle->distance(x, away);
    CAPTURE(k, x.transpose(), truth, found);
    CHECK(found <= std::max(truth, -0.1 / slope) + kOfSpline);
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
  const double slope = grid.bounds(-0.1).slope, clearance = 0.1, far = kRadius + clearance * slope;
  const ObstacleWalls walls(3, {make_grid_obstacle(grid, 0, "the ball")}, clearance);
  const MoveClearance beyond = walls.clearance(Vector3d(-2, far + 1e-3, 0), Vector3d(2, far + 1e-3, 0));
  CHECK(beyond.lower > 0);
  CHECK(beyond.lower < 2e-3);
  CHECK(walls.clearance(Vector3d(-2, kRadius + 0.099, 0), Vector3d(2, kRadius + 0.099, 0)).upper < 0);
}

TEST_CASE("grid obstacles: grids that are none are refused in words") {
  CHECK_THROWS_WITH(make_grid_obstacle(ball_grid(0.1, -0.1), 0, "the grid a.sdf"),
                    Catch::Contains("the grid a.sdf") && Catch::Contains("wider margin"));
  CHECK_THROWS_AS(make_grid_obstacle(ball_grid(0.1), -1, "a"), OptionError);
  CHECK_THROWS_AS(make_grid_obstacle(ball_grid(0.1), std::numeric_limits<double>::quiet_NaN(), "a"), OptionError);
  const GridShape shape{Vector3d::Zero(), 0.1, {5, 5, 5}};
  CHECK_THROWS_WITH(make_grid_obstacle(DistanceGrid(shape, std::vector<double>(125, -1.0)), 0, "a"),
                    Catch::Contains("nowhere above"));
}

}  // namespace leastcost
