// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// First paths down the field of least arrival costs: near the least cost whatever the cost depends on, and clear.
#include <leastcost/problems/initializers/eikonal.hpp>

#include <cmath>
#include <memory>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

/// Cost of the first path as it comes.
double first_cost(const Problem& problem, int cells = 100) {
  EikonalOptions options;
  options.cells = cells;
  return PathEnergy(problem, 1).cost(EikonalInitializer(options).first_path(problem, {}).path);
}

std::shared_ptr<const ConstraintManifold> square(double half) {
  return std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions{.dimension = 2, .box = {Vector2d::Constant(-half), Vector2d::Constant(half)}});
}

std::shared_ptr<const SegmentCost> hill(double y) {
  return make_refractive_index_cost({refraction::Formula{"1 + 2 * exp(-x^2 - (y - y0)^2)", {{"y0", y}}}}, 2);
}

}  // namespace

TEST_CASE("eikonal: around a hill, on the cheaper side of it") {
  const Problem level = between(square(3), hill(0), Vector2d(-2, 0), Vector2d(2, 0));
  const double truth = 6.030127200428;
  CHECK(first_cost(level) > truth * (1 - 1e-6));
  CHECK(first_cost(level, 50) < truth * 1.01);
  if (!test::kSanitized) CHECK(first_cost(level, 200) < truth * 1.002);
  for (const double side : {-0.1, 0.1}) {
    const Problem problem = between(square(3), hill(side), Vector2d(-2, 0), Vector2d(2, 0));
    const Points u = EikonalInitializer().first_path(problem, {}).path.u;
    CHECK(u.row(1).mean() * side < 0);
  }
}

TEST_CASE("eikonal: a cost that depends on the direction, up to twenty times") {
  const double c = std::cos(0.4), s = std::sin(0.4);
  const Eigen::Matrix2d turn{{c, -s}, {s, c}};
  for (const auto& [ratio, worst] : {std::pair(2.0, 0.005), std::pair(5.0, 0.03), std::pair(20.0, 0.15)}) {
    MetricTensorOptions options;
    options.matrix = turn * Vector2d(1, ratio * ratio).asDiagonal() * turn.transpose();
    const auto cost = make_metric_tensor_cost(options, 2);
    for (const Vector2d& target : {Vector2d(0.8, 0.3), Vector2d(-0.7, 0.8), Vector2d(0.1, -0.9)}) {
      const Problem problem = between(square(1), cost, Vector2d(0.05, 0.02), target);
      const double truth = move_cost(*cost, problem.source.u, target);
      CAPTURE(ratio, target.transpose(), truth);
      if (test::kSanitized && ratio == 5) continue;
      const double found = first_cost(problem);
      CHECK(found >= truth * (1 - 1e-12));
      CHECK(found <= truth * (1 + worst));
    }
  }
}

TEST_CASE("eikonal: a current that is faster than the boat where it starts", "[.slow]") {
  const auto cost = make_zermelo_cost({.speed = "1", .flow = flow::Formula{{"-y", "0"}}}, 2);
  const auto box = std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions{.dimension = 2, .box = {Vector2d(-2, -3), Vector2d(7, 3)}});
  const Problem problem = between(box, cost, Vector2d(3.66, -1.86), Vector2d(0, 0));
  const double truth = 5.45786526;
  for (const int cells : {60, 100, 200}) {
    if (cells > 100 && test::kSanitized) continue;
    CAPTURE(cells);
    const double found = first_cost(problem, cells);
    CHECK(found >= truth);
    CHECK(found <= truth * 1.02);
  }
  CHECK(find(problem, 40, EikonalInitializer()).curve.cost == Approx(truth).epsilon(1e-3));
}

TEST_CASE("eikonal: among obstacles, thin walls too") {
  // A wall between the nodes of the lattice, open above y = 0.72 only; a disc before it.
  const auto wall = make_box_obstacle({Vector2d(0.005, -1), Vector2d(0.006, 0.72)});
  const auto free = std::make_shared<const FreeSpace>(
      square(1), FreeSpace::Obstacles{wall, make_ball({Vector2d(-0.4, 0.3), 0.2})}, 0.001);
  const Problem problem = between(free, make_euclidean_cost(2), Vector2d(-0.8, -0.5), Vector2d(0.7, -0.2));
  const FirstPath first = EikonalInitializer().first_path(problem, {});
  const auto clearance = measure_clearance(*free, first.path.u, false, {});
  REQUIRE(clearance);
  CHECK(clearance->lower >= -1e-12);
  const double over_the_wall = (Vector2d(0.005, 0.72) - Vector2d(-0.8, -0.5)).norm() + 0.001 +
                               (Vector2d(0.006, 0.72) - Vector2d(0.7, -0.2)).norm();
  const double length = PathEnergy(problem, 1).cost(first.path);
  CHECK(length >= over_the_wall);  // the disc is in its way
  CHECK(length <= over_the_wall * 1.03);

  const auto closed_wall = make_box_obstacle({Vector2d(0.005, -1.1), Vector2d(0.006, 1.1)});
  const auto halves = std::make_shared<const FreeSpace>(square(1), FreeSpace::Obstacles{closed_wall}, 0.001);
  const Problem blocked = between(halves, make_euclidean_cost(2), Vector2d(-0.8, -0.5), Vector2d(0.7, -0.2));
  CHECK_THROWS_WITH(EikonalInitializer().first_path(blocked, {}), Catch::Contains("no path reaches the target"));
}

TEST_CASE("eikonal: in a chart") {
  // A great circle, where lines of coordinates are none.
  const auto sphere = make_parametric_manifold({.surface = parametric::Sphere{}});
  const Problem problem = between(sphere, make_euclidean_cost(3), Vector2d(0.3, 0.7), Vector2d(2.2, 0.9));
  const Points ends = positions(*sphere, {(Points(2, 2) << 0.3, 2.2, 0.7, 0.9).finished(), {}, false});
  const double truth = std::acos(ends.col(0).dot(ends.col(1)));
  CHECK(first_cost(problem) >= truth * (1 - 1e-3));  // chords
  CHECK(first_cost(problem) <= truth * 1.005);
}

TEST_CASE("eikonal: what it does not do is said") {
  const EikonalInitializer eikonal;
  const Problem ring = closed(space(2), make_euclidean_cost(2));
  CHECK_THROWS_WITH(eikonal.first_path(ring, {}), Catch::Contains("a ring has no ends"));
  const Problem solid = between(space(3), make_euclidean_cost(3), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0));
  CHECK_THROWS_WITH(eikonal.first_path(solid, {}), Catch::Contains("two coordinates"));
  EikonalOptions options;
  options.cells = 1;
  CHECK_THROWS_AS(EikonalInitializer(options), OptionError);
  options.cells = 100;
  options.lower = Vector2d(2, 2), options.upper = Vector2d(1, 3);
  const Problem plane = between(space(2), make_euclidean_cost(2), Vector2d(0, 0), Vector2d(1, 0));
  CHECK_THROWS_WITH(EikonalInitializer(options).first_path(plane, {}), Catch::Contains("greater than lower"));
  options.upper = Vector2d(3, 3);
  CHECK_THROWS_WITH(EikonalInitializer(options).first_path(plane, {}), Catch::Contains("outside the searched box"));
}

}  // namespace leastcost::test
