// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/taut_path.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "problems/obstacles/crossing_word.hpp"
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kExcess = 1e-6;

ObstacleWalls::Obstacles discs(const std::vector<Eigen::Vector3d>& all) {
  ObstacleWalls::Obstacles made;
  for (const Eigen::Vector3d& disc : all) made.push_back(make_ball({disc.head(2), disc[2]}));
  return made;
}

Points polyline(const std::vector<Vector2d>& points) {
  Points columns(2, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Index>(i)) = points[i];
  return columns;
}

Problem taut_problem(ObstacleWalls::Obstacles obstacles, double clearance, const Vector2d& from, const Vector2d& to) {
  const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(space, std::move(obstacles), clearance);
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {from};
  problem.target = {to};
  return problem;
}

FindOptions pulled_tight(int points) {
  FindOptions options;
  options.points = points;
  options.post_processors = {std::make_shared<const TautPostProcessor>()};
  return options;
}

/// Of the taut path that `start` makes: its least length, after what holds for every one of them.
double least_of(const ObstacleWalls::Obstacles& obstacles, double clearance, const std::vector<Vector2d>& start) {
  const ObstacleWalls walls(2, obstacles, clearance);
  const auto taut = taut_path(walls, polyline(start), kExcess, {});
  REQUIRE(taut.has_value());
  CHECK(taut->polyline.col(0) == start.front());
  CHECK(taut->polyline.rightCols(1) == start.back());
  CHECK(taut->length >= taut->least * (1 - 1e-15));
  CHECK(taut->length <= taut->least * (1 + kExcess));
  for (Index i = 0; i + 1 < taut->polyline.cols(); ++i)
    CHECK(walls.clearance(taut->polyline.col(i), taut->polyline.col(i + 1)).upper >= -1e-14 * walls.size());
  CHECK(unheld_turn(walls, taut->polyline, {}) == 0);
  return taut->least;
}

}  // namespace

TEST_CASE("taut: around a disc, on either side and once more about it") {
  const auto disc = discs({{0, 0, 1}});
  const double half = 2 * std::sqrt(3.0) + std::numbers::pi / 3;  // ORACLES D5
  CHECK(least_of(disc, 0, {{-2, 0}, {0, 2}, {2, 0}}) == Approx(half).epsilon(1e-14));
  CHECK(least_of(disc, 0, {{-2, 0}, {0, -2}, {2, 0}}) == Approx(half).epsilon(1e-14));
  CHECK(least_of(disc, 0, {{-2, 0}, {0, 2}, {2, 1}, {2, -2}, {-2, -2}, {-2, 3}, {3, 3}, {2, 0}}) ==
        Approx(half + 2 * std::numbers::pi).epsilon(1e-14));
  CHECK(least_of(disc, 0, {{-2, 0}, {0, 2}, {2, 1}, {2, 3}, {-2, 3}, {2, 3}, {2, 0}}) == Approx(half).epsilon(1e-14));
  // With a clearance the disc is larger by it, wherever the clearance comes from.
  CHECK(least_of(discs({{0, 0, 0.25}}), 0.75, {{-2, 0}, {0, 2}, {2, 0}}) == Approx(half).epsilon(1e-14));
}

TEST_CASE("taut: over one disc and under the next") {
  // Tangents from the ends and the one between the discs, which crosses the line of the centres in its middle.
  const double inner = std::asin(2.0 / 5), outer = std::asin(1.0 / 3);
  const double expected = 2 * (std::sqrt(8.0) + (outer + inner)) + std::sqrt(21.0);
  const auto two = discs({{0, 0, 1}, {5, 0, 1}});
  CHECK(least_of(two, 0, {{-3, 0}, {0, 1.5}, {2.5, 0}, {5, -1.5}, {8, 0}}) == Approx(expected).epsilon(1e-14));
  CHECK(least_of(two, 0, {{-3, 0}, {0, 1.5}, {5, 1.5}, {8, 0}}) ==
        Approx(2 * (std::sqrt(8.0) + outer) + 5).epsilon(1e-14));
}

TEST_CASE("taut: around corners with a clearance") {
  const ObstacleWalls::Obstacles wall = {make_box_obstacle({Vector2d(-0.5, -9), Vector2d(0.5, 0)})};
  const double r = 0.3, far = 2 - 0.5;  // from (-2, 0) over the two corners at (-+0.5, 0)
  const double expected = 2 * (std::sqrt(far * far - r * r) + r * std::asin(r / far)) + 1;
  CHECK(least_of(wall, r, {{-2, 0}, {0, 3}, {2, 0}}) == Approx(expected).epsilon(1e-14));
  Eigen::MatrixXd corners(4, 2);  // a dent, into which a taut path does not go
  corners << -1, 0, 0, 0.9, 1, 0, 0, 1;
  const auto dented = make_polygon({corners});
  const double lid = std::sqrt(4 + 1), turned = 2 * (std::atan2(1, 2) + std::asin(0.1 / lid));
  CHECK(least_of({dented}, 0.1, {{-2, 0}, {0, 2}, {2, 0}}) ==
        Approx(2 * std::sqrt(lid * lid - 0.01) + 0.1 * turned).epsilon(1e-14));
}

TEST_CASE("taut: discs far smaller than the way between them, and a disc that is only grazed") {
  const double r = 1e-6;
  const double d = std::hypot(5, 0.1), turned = 2 * (std::atan2(0.1, 5) + std::asin(r / d));
  CHECK(least_of(discs({{5, 0.1, r}}), 0, {{0, 0}, {5, 1}, {10, 0}}) ==
        Approx(2 * std::sqrt(d * d - r * r) + r * turned).epsilon(1e-14));
  CHECK(least_of(discs({{5, 0.1, r}}), 0, {{0, 0}, {5, -1}, {10, 0}}) == Approx(10).epsilon(1e-15));
  CHECK(least_of(discs({{5, -1, 1}}), 0, {{0, 0}, {5, 1}, {10, 0}}) == Approx(10).epsilon(1e-15));
}

TEST_CASE("taut: random discs, from random ways, what is taut stays as it is", "[slow_sanitized]") {
  std::mt19937 engine(20261123);
  std::uniform_real_distribution<double> place(0.8, 9.2), size(0.05, 1);
  int found = 0;
  for (unsigned k = 0; k < 40; ++k) {
    std::vector<Eigen::Vector3d> all;
    while (all.size() < 25) {
      const Eigen::Vector3d disc(place(engine), place(engine), size(engine));
      if (std::min(disc.head(2).norm(), (disc.head(2) - Vector2d(10, 10)).norm()) > disc[2] + 0.1) all.push_back(disc);
    }
    const Problem problem = taut_problem(discs(all), 0, {0, 0}, {10, 10});
    FirstPath first;
    try {
      first = RrtInitializer(RrtOptions{.seed = static_cast<int>(k)}).first_path(problem, {});
    } catch (const InitializationError&) {
      continue;
    }
    ++found;
    const ObstacleWalls walls(2, discs(all), 0);
    const auto once = taut_path(walls, first.path.u, kExcess, {});
    CAPTURE(k);
    REQUIRE(once.has_value());
    CHECK(unheld_turn(walls, once->polyline, {}) == 0);
    double given = 0;
    for (Index i = 0; i + 1 < first.path.u.cols(); ++i) given += (first.path.u.col(i + 1) - first.path.u.col(i)).norm();
    CHECK(once->least <= given);
    const auto again = taut_path(walls, once->polyline, kExcess, {});
    REQUIRE(again.has_value());
    CHECK(again->least == Approx(once->least).epsilon(1e-13));
  }
  CHECK(found > 30);
}

TEST_CASE("taut: the word of a path") {
  const std::vector<Round> two = {{0, {0, 0}, 1}, {0, {0.5, 0}, 1}, {1, {5, 0}, 1}};
  CHECK(crossing_word(two, polyline({{-3, 0}, {0, 2}, {5, 2}, {8, 0}})) == std::vector{1, 2});
  CHECK(crossing_word(two, polyline({{-3, 0}, {0, 2}, {5, -2}, {8, 0}})) == std::vector{1});
  CHECK(crossing_word(two, polyline({{-3, 0}, {6, 2}, {-1, 3}, {8, 0}})) == std::vector{1, 2});
  CHECK(crossing_word(two, polyline({{-3, 0}, {1, 2}, {1, -2}, {-3, -2}, {-3, 1}, {1, 2}})) == std::vector{1, 1});
  CHECK(crossing_word(two, polyline({{-3, 0}, {1, 2}, {1, -2}, {8, 0}, {1, -2}, {1, 2}, {-3, 0}})).empty());
  CHECK(crossing_word(two, polyline({{0, 2}, {0, 3}, {5, 3}})) == std::vector{1});  // from the line of the ray
}

TEST_CASE("taut: certified as the shortest of its class, with the value covered") {
  for (const int n : {5, 32, 200}) {
    const Problem problem = taut_problem(discs({{0, 0, 1}}), 0, {-2, 0}, {2, 0});
    const Result result = find_path(problem, WaypointsInitializer(Vector2d(0.1, 2)), NoSolver(), pulled_tight(n));
    const double truth = 2 * std::sqrt(3.0) + std::numbers::pi / 3;
    REQUIRE(result.status == Status::certified);
    CHECK(result.certificate.scope == Scope::least_of_class);
    CHECK(result.certificate.clearance->proved);
    CHECK(result.certificate.estimate.value == result.curve.cost);
    CHECK(std::abs(result.curve.cost - truth) <= result.certificate.estimate.error);
    CHECK(result.certificate.estimate.error <= 1.01e-6 * truth);
    CHECK(result.path.free_count() == n);
    CHECK(result.certificate.spacing < 1e-12);
  }
}

TEST_CASE("taut: from the solved chain where the first path goes through") {
  const Problem problem = taut_problem(discs({{0, 0.05, 1}}), 0, {-2, 0}, {2, 0});
  const Result result = find_path(problem, WaypointsInitializer(Vector2d(0, -0.9)), Newton(), pulled_tight(40));
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.scope == Scope::least_of_class);
  const Result left = find_path(problem, WaypointsInitializer(Vector2d(0, -0.9)), NoSolver(), pulled_tight(40));
  CHECK(left.status == Status::uncertified);
  CHECK(left.certificate.failures.front().name() == "touches");
}

TEST_CASE("taut: what it cannot do is said") {
  const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3});
  Problem problem = taut_problem({}, 0, {0, 0}, {1, 0});
  problem.manifold = space;
  problem.cost = make_euclidean_cost(3);
  problem.source.u = Eigen::Vector3d(0, 0, 0);
  problem.target.u = Eigen::Vector3d(1, 0, 0);
  PostProcessed current;
  current.chain.u = Points::Zero(3, 3);
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(TautPostProcessor().apply(problem, {}, current, {}), Contains("needs the plane or space"));
  Problem ring = taut_problem(discs({{0, 0, 1}}), 0, {-2, 0}, {2, 0});
  ring.ring = true;
  CHECK_THROWS_WITH(TautPostProcessor().apply(ring, {}, current, {}), Contains("ring"));
}

TEST_CASE("taut: where next to nothing is required, walls are still no way through") {
  Eigen::MatrixXd corners(3, 2);
  corners << 8.75, 9.625, 12.25, 13, 0.125, 3.875;
  const auto triangle = make_polygon({corners});
  const Vector2d from(1.25, 7.375), to(3.25, -0.875), tip(0.125, 3.875);
  Points through(2, 4);
  through << -0.625, 1.875, 1.25, -0.25, 2.625, 4.75, 3, 1;
  const double around = (tip - from).norm() + (to - tip).norm();
  for (const int n : {1, 7, 12}) {
    const Problem problem = taut_problem({triangle}, 1e-9, from, to);
    const Result result = find_path(problem, WaypointsInitializer(through), NoSolver(), pulled_tight(n));
    CAPTURE(n);
    CHECK(result.status == Status::certified);
    CHECK(result.curve.cost == Approx(around).epsilon(1e-7));
  }
  const auto wall = make_box_obstacle({Vector2d(-0.05, -5), Vector2d(0.05, 4.5)});
  Points over(2, 2);
  over << -3, 1.5, 9, 6;
  const Vector2d left(-3, 0), right(1.5, 2), corner(-0.05, 4.5), other(0.05, 4.5);
  const double expected = (corner - left).norm() + 0.1 + (right - other).norm();
  for (const int n : {1, 40}) {
    const Problem problem = taut_problem({wall}, 5e-11, left, right);
    const Result result = find_path(problem, WaypointsInitializer(over), NoSolver(), pulled_tight(n));
    CAPTURE(n);
    CHECK(result.status == Status::certified);
    CHECK(result.curve.cost == Approx(expected).epsilon(1e-7));
    CHECK(ObstacleWalls(2, {wall}, 5e-11).clearance(left, right).upper < -1);
  }
}

TEST_CASE("taut: the bar has room for rounding, far from the origin as well") {
  const double truth = 2 * std::sqrt(3.0) + std::numbers::pi / 3;
  for (const double shift : {0.0, 1e3, 1e5}) {
    for (const double excess : {1e-10, 1e-6, 1e-2}) {
      const Vector2d o(shift, -shift);
      const Problem problem = taut_problem(discs({{o[0], o[1], 1}}), 0, o - Vector2d(2, 0), o + Vector2d(2, 0));
      FindOptions options = pulled_tight(20);
      options.post_processors = {std::make_shared<const TautPostProcessor>(TautOptions{.excess = excess})};
      const Result result = find_path(problem, WaypointsInitializer(o + Vector2d(0.1, 2)), NoSolver(), options);
      const CostEstimate& estimate = result.certificate.estimate;
      CAPTURE(shift, excess, estimate.value - truth, estimate.error);
      REQUIRE(result.status == Status::certified);
      CHECK(*estimate.lower <= truth);
      CHECK(estimate.error >= 0);
      CHECK(std::abs(estimate.value - truth) <= estimate.error);
      CHECK(estimate.error <= 2 * excess * truth + 1e-5 * (shift > 0));
    }
  }
  for (const double excess : {0.0, 1e-12, 0.1, std::nan("")})
    CHECK_THROWS_AS(TautPostProcessor(TautOptions{.excess = excess}), OptionError);
}

TEST_CASE("taut: an obstacle far away changes nothing") {
  const Problem problem = taut_problem(discs({{0, 0, 1}, {0, -5e6, 1}}), 0, {-2, 0}, {2, 0});
  const Result result = find_path(problem, WaypointsInitializer(Vector2d(0.1, 2)), NoSolver(), pulled_tight(64));
  CHECK(result.status == Status::certified);
}

TEST_CASE("taut: a polyline that would leave the domain is not delivered") {
  Problem problem = taut_problem(discs({{0, 0, 1}}), 0, {-2, 0}, {2, 0});
  const auto box = std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions{.dimension = 2, .box = {Vector2d(-3, -3), Vector2d(3, 1.0001)}});
  problem.manifold = std::make_shared<const FreeSpace>(box, discs({{0, 0, 1}}), 0);
  Points below_the_lid(2, 2);
  below_the_lid << -1, 1, 1.00005, 1.00005;
  for (const double excess : {1e-2, 1e-6}) {
    FindOptions options = pulled_tight(64);
    options.post_processors = {std::make_shared<const TautPostProcessor>(TautOptions{.excess = excess})};
    const Result result = find_path(problem, WaypointsInitializer(below_the_lid), NoSolver(), options);
    CHECK((result.status == Status::certified) == (excess < 1e-3));
    if (result.status == Status::certified) CHECK(result.curve.x.row(1).maxCoeff() <= 1.0001);
  }
}

/// A path that touches a disc with a single point on every level has the same margin on all of them: the differences
/// between the levels were zero, the answer called exact, and too long by what the margin costs.
TEST_CASE("obstacles: a chain that grazes a disc has the cost of its margin in its bar") {
  for (const double depth : {1e-5, 1e-4, 1e-3, 1e-2}) {
    const Vector2d center(5.02, depth - 1);
    const Problem problem = taut_problem(discs({{center[0], center[1], 1}}), 0, {0, 0}, {10, 0});
    FindOptions options;
    options.points = 31;
    const Result result = find_path(problem, WaypointsInitializer(Vector2d(5, 1)), Newton(), options);
    const double truth = least_of(discs({{center[0], center[1], 1}}), 0, {{0, 0}, {5, 1}, {10, 0}});
    CAPTURE(depth, result.certificate.estimate.value - truth, result.certificate.estimate.error,
            result.certificate.estimate.method);
    CHECK(std::abs(result.certificate.estimate.value - truth) <= result.certificate.estimate.error + 1e-14);
    CHECK(result.certificate.estimate.error < 1e-3 * truth);
  }
}

}  // namespace leastcost
