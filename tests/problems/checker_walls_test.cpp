// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/checker_walls.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Vector = Eigen::VectorXd;

double to_origin(const Vector& x) { return x.norm() - 1; }

double to_two_discs(const Vector& x) {
  return std::min((x - Vector2d(-1.5, 0.2)).norm(), (x - Vector2d(1.5, -0.2)).norm()) - 1;
}

Problem outside(std::shared_ptr<const Walls> walls, const Vector& source, const Vector& target) {
  Problem problem;
  const auto plane = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{});
  problem.manifold = std::make_shared<const FreeSpace>(plane, std::move(walls));
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {source};
  problem.target = {target};
  return problem;
}

}  // namespace

TEST_CASE("checker walls: the clearance of a move is proved, and attained") {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> place(-4, 4);
  long calls = 0;
  for (const double curvature : {0.0, 2.0}) {
    DistanceChecker checker;
    checker.distance = [&calls](const Vector& x) { return ++calls, to_two_discs(x); };
    checker.curvature = curvature;  // 1 / 0.5 where the centres are 0.5 away
    checker.curvature_from = -0.5;
    checker.clearance = 0.2;
    const auto walls = make_checker_walls(2, checker);
    for (int k = 0; k < 200; ++k) {
      const Vector2d a(place(engine), place(engine)), b(place(engine), place(engine));
      const auto to = [&](const Vector2d& center) {
        const double t = std::clamp((center - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        return (a + t * (b - a) - center).norm() - 1.2;
      };
      const double truth = std::min(to({-1.5, 0.2}), to({1.5, -0.2}));
      const MoveClearance found = walls->clearance(a, b);
      CAPTURE(k, a.transpose(), b.transpose(), truth, found.lower, found.upper);
      CHECK(found.proved);
      CHECK(found.lower <= truth);
      CHECK(found.upper >= truth - 1e-12);
      CHECK(found.lower >= found.upper - std::max(1e-4, std::abs(found.upper) / 2));
      CHECK(to_two_discs(found.place) - 0.2 == Approx(found.upper).margin(1e-12));
      if (truth < 0) CHECK(found.upper < 0);
    }
  }
  CHECK(calls < 400 * 400);
}

TEST_CASE("checker walls: around a disc as among obstacles, by values alone, with a gradient, with a curvature") {
  const double truth = 2 * std::sqrt(3.0) + M_PI / 3;
  for (const int kind : {0, 1, 2, 3}) {
    CAPTURE(kind);
    DistanceChecker checker;
    checker.distance = to_origin;
    checker.size = 4;
    checker.depth = 1;
    if (kind >= 1) checker.gradient = [](const Vector& x) -> Vector { return x.normalized(); };
    if (kind >= 2) checker.curvature = 2, checker.curvature_from = -0.5;
    if (kind == 3) {  // of another unit
      checker.distance = [](const Vector& x) { return 3 * to_origin(x); };
      checker.gradient = [](const Vector& x) -> Vector { return 3 * x.normalized(); };
      checker.lipschitz = checker.depth = 3;
      checker.curvature = 6, checker.curvature_from = -1.5;
    }
    const Problem problem = outside(make_checker_walls(2, checker), Vector2d(-2, 0), Vector2d(2, 0));
    FindOptions options;
    options.points = 60;
    const Result result = find_path(problem, BowInitializer(), Newton(), options);
    for (const auto& failure : result.certificate.failures) UNSCOPED_INFO(failure.name() + ": " + failure.message);
    CHECK(result.status == Status::certified);
    CHECK(result.curve.cost > truth);
    CHECK(result.curve.cost < truth * (1 + (kind < 2 ? 2e-3 : 5e-4)));
    REQUIRE(result.certificate.clearance);
    CHECK(result.certificate.clearance->proved);
    CHECK(result.certificate.clearance->lower >= -1e-9);
    CHECK(result.certificate.clearance->upper <= 1e-3);
  }
}

TEST_CASE("checker walls: a yes or no is checked, kept to, and never proved") {
  FreeChecker checker;
  checker.is_free = [](const Vector& x) { return to_origin(x) > 0; };
  checker.resolution = 0.01;
  const auto walls = make_checker_walls(2, checker);
  const MoveClearance clear = walls->clearance(Vector2d(-2, 1.1), Vector2d(2, 1.1));
  CHECK_FALSE(clear.proved);
  CHECK(clear.lower == 0);
  const MoveClearance through = walls->clearance(Vector2d(-2, 0), Vector2d(2, 0));
  CHECK(through.upper < 0);
  CHECK(to_origin(through.place) <= 0);

  Points above(2, 1);  // a way that is free and pulled against the disc
  above << 0, 2;
  FindOptions options;
  options.points = 40;
  const Result held =
      find_path(outside(walls, Vector2d(-2, 0), Vector2d(2, 0)), WaypointsInitializer(above), Newton(), options);
  CHECK(held.status != Status::certified);
  // One that nothing holds.
  const Result free =
      find_path(outside(walls, Vector2d(-2, 1.5), Vector2d(2, 1.2)), RrtInitializer(), Newton(), options);
  CHECK(free.status == Status::certified);
  REQUIRE(free.certificate.clearance);
  CHECK_FALSE(free.certificate.clearance->proved);
  CHECK(free.curve.cost == Approx(std::hypot(4, 0.3)).epsilon(1e-9));
}

TEST_CASE("checker walls: what they do not know is not clear, and faults have names") {
  DistanceChecker blind;
  blind.distance = [](const Vector& x) { return x[0] > 0 ? std::numeric_limits<double>::quiet_NaN() : 1; };
  blind.depth = 1;
  const auto walls = make_checker_walls(2, blind);
  CHECK(walls->room(Vector2d(-1, 0), Vector2d(1, 0), 1) == 0);
  CHECK(std::isnan(walls->clearance(Vector2d(-1, 0), Vector2d(1, 0)).lower));
  CHECK(std::isnan(walls->clearance(Vector2d(1, 0), Vector2d(1, 0)).lower));
  CHECK_THROWS_WITH(make_checker_walls(2, DistanceChecker{}), Catch::Contains("needs a function"));
  blind.lipschitz = 0;
  CHECK_THROWS_WITH(make_checker_walls(2, blind), Catch::Contains("greater than 0"));
  FreeChecker coarse;
  coarse.is_free = [](const Vector&) { return true; };
  CHECK_THROWS_AS(make_checker_walls(2, coarse), OptionError);
}

}  // namespace leastcost
