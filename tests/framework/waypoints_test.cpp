// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/replan/waypoints.hpp>

#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost {
namespace {

using Catch::Matchers::WithinAbs;
using Eigen::Vector2d;
using std::numbers::pi;

const FindOptions kNoCertificate{.points = 40, .certificate = {.enabled = false}};

Problem waypoint_problem(std::shared_ptr<const ConstraintManifold> manifold, const Eigen::VectorXd& source,
                         const Eigen::VectorXd& target) {
  Problem problem;
  problem.cost = make_euclidean_cost(manifold->dimensions().ambient);
  problem.manifold = std::move(manifold);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

std::shared_ptr<const ConstraintManifold> flat_plane() {
  return std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
}

Problem slide_to_pi() {
  Problem problem = waypoint_problem(flat_plane(), Vector2d(0, 0), Vector2d(pi, -2));
  problem.cost = make_travel_time_cost({.gravity = 1}, 2, problem.source.u);
  return problem;
}

}  // namespace

TEST_CASE("waypoints: exactly so many on a straight line") {
  const Problem problem = waypoint_problem(flat_plane(), Vector2d(1, 2), Vector2d(4, 6));
  const Result result = find_path(problem, StraightInitializer(), Newton(), kNoCertificate);
  for (const int count : {2, 3, 11, 42, 1000}) {
    const Waypoints points = place_waypoints(problem, result, {.count = count});
    REQUIRE(points.x.cols() == count);
    for (Index i = 0; i < count; ++i) {
      const double part = static_cast<double>(i) / (count - 1);
      CHECK_THAT((points.x.col(i) - Vector2d(1 + 3 * part, 2 + 4 * part)).norm(), WithinAbs(0, 1e-12));
      CHECK_THAT(points.cost[i], WithinAbs(5 * part, 1e-12));
    }
    CHECK_THAT(points.gap.value(), WithinAbs(0, 1e-12));
    CHECK_FALSE(points.clearance.has_value());
  }
}

TEST_CASE("waypoints: so far apart, and the last move has what is left") {
  const Problem problem = waypoint_problem(flat_plane(), Vector2d(0, 0), Vector2d(3, 4));
  const Result result = find_path(problem, StraightInitializer(), Newton(), kNoCertificate);
  const Waypoints some = place_waypoints(problem, result, {.spacing = 1.5});
  REQUIRE(some.x.cols() == 5);
  CHECK_THAT(some.cost[3], WithinAbs(4.5, 1e-12));
  CHECK_THAT(some.cost[4], WithinAbs(5, 1e-12));
  CHECK_THAT((some.x.col(1) - Vector2d(0.9, 1.2)).norm(), WithinAbs(0, 1e-12));
  CHECK(place_waypoints(problem, result, {.spacing = 0.1}).x.cols() == 51);  // rounding makes no 52nd
  CHECK(place_waypoints(problem, result, {.spacing = 7}).x.cols() == 2);
}

TEST_CASE("waypoints: at equal angles of an arc on a sphere, and on the sphere") {
  const Problem problem =
      waypoint_problem(std::make_shared<test::Sphere>(), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1));
  const Result result = find_path(problem, StraightInitializer(), Newton(), kNoCertificate);
  const Waypoints points = place_waypoints(problem, result, {.count = 8});
  for (Index i = 0; i < 8; ++i) {
    const double angle = pi / 2 * static_cast<double>(i) / 7;
    CHECK_THAT((points.x.col(i) - Eigen::Vector3d(std::cos(angle), 0, std::sin(angle))).norm(), WithinAbs(0, 1e-5));
    CHECK_THAT(points.x.col(i).norm(), WithinAbs(1, 1e-12));
  }
}

TEST_CASE("waypoints: a ring is not closed by a repeated point") {
  Problem problem = waypoint_problem(flat_plane(), {}, {});
  problem.ring = true;
  Result result;
  result.path.ring = true;
  result.path.u.resize(2, 360);
  for (Index i = 0; i < 360; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / 360;
    result.path.u.col(i) = Vector2d(std::cos(angle), std::sin(angle));
  }
  result.curve.x.resize(2, 361);
  result.curve.x << result.path.u, result.path.u.col(0);
  const Waypoints points = place_waypoints(problem, result, {.count = 7});
  REQUIRE(points.x.cols() == 7);
  for (Index i = 0; i < 7; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / 7;
    CHECK_THAT((points.x.col(i) - Vector2d(std::cos(angle), std::sin(angle))).norm(), WithinAbs(0, 1e-4));
  }
  CHECK_THAT(points.gap.value(), WithinAbs(14 * std::sin(pi / 7) - 2 * pi, 1e-3));
  CHECK_THROWS_AS(place_waypoints(problem, result, {.count = 2}), OptionError);
}

TEST_CASE("waypoints: the brachistochrone's places at equal times") {
  // x = t - sin t, y = cos t - 1 is at the angle t after t seconds under gravity 1.
  const Problem problem = slide_to_pi();
  double before = 0;
  for (const int n : {40, 81}) {
    FindOptions options = kNoCertificate;
    options.points = n;
    const Result result = find_path(problem, StraightInitializer(), Newton({.tolerance = 1e-14}), options);
    const Waypoints points = place_waypoints(problem, result, {.spacing = 0.25});
    double worst = 0;
    for (Index i = 0; i + 1 < points.x.cols(); ++i) {
      const double t = 0.25 * static_cast<double>(i);
      worst = std::max(worst, (points.x.col(i) - Vector2d(t - std::sin(t), std::cos(t) - 1)).norm());
      CHECK_THAT(points.cost[i], WithinAbs(t, 1e-14));
    }
    CHECK(worst < 2.0 / (n * n));
    if (before > 0) CHECK(worst < before / 2);
    before = worst;
  }
}

TEST_CASE("waypoints: in a chart they lie on the surface, and as many as the points are the points") {
  const Problem problem =
      waypoint_problem(make_parametric_manifold({.surface = parametric::Torus{}}), Vector2d(0, 0.5), Vector2d(2, -1));
  const Result result = find_path(problem, StraightInitializer(), Newton(), kNoCertificate);
  const Waypoints same = place_waypoints(problem, result, {.count = 42});
  CHECK((same.path.u - result.path.u).cwiseAbs().maxCoeff() < 1e-3);  // a chain there is equal to second order
  const Waypoints few = place_waypoints(problem, result, {.count = 9});
  CHECK(few.path.u.rows() == 2);
  CHECK(few.x.rows() == 3);
  CHECK((few.x - positions(*problem.manifold, few.path)).norm() == 0);
}

TEST_CASE("waypoints: few of them cut the corner of an obstacle and say so, many do not") {
  const auto ball = make_ball({.center = Vector2d(0, 0), .radius = 1});
  const auto space = std::make_shared<FreeSpace>(flat_plane(), FreeSpace::Obstacles{ball}, 0.05);
  const Problem problem = waypoint_problem(space, Vector2d(-2, 0), Vector2d(2, 0));
  Points over(2, 1);
  over << 0, 2;
  FindOptions options = kNoCertificate;
  options.points = 100;
  const Result result = find_path(problem, WaypointsInitializer(over), Newton(), options);
  const Waypoints three = place_waypoints(problem, result, {.count = 3});
  REQUIRE(three.clearance.has_value());
  CHECK(three.touches);
  // The middle is the top of the circle; the straight move to it from (2, 0) passes the centre at about 1.05 / sqrt(1 +
  // (1.05 / 2)^2).
  CHECK_THAT(three.clearance->upper, WithinAbs(1.05 / std::hypot(1, 1.05 / 2) - 1.05, 2e-3));
  CHECK(three.gap.value() < 0);
  const Waypoints all = place_waypoints(problem, result, {.count = 102});
  CHECK(all.clearance->upper > -2e-4);  // of second order in their distance
  // Wherever they lie, each of them keeps the clearance.
  const Waypoints many = place_waypoints(problem, result, {.count = 1234});
  for (Index i = 0; i < many.x.cols(); ++i) CHECK(many.x.col(i).norm() >= 1.05 - 1e-12);
}

TEST_CASE("waypoints: what cannot be is refused") {
  const Problem problem = waypoint_problem(flat_plane(), Vector2d(0, 0), Vector2d(3, 4));
  const Result result = find_path(problem, StraightInitializer(), Newton(), kNoCertificate);
  CHECK_THROWS_AS(place_waypoints(problem, result, {}), OptionError);
  CHECK_THROWS_AS(place_waypoints(problem, result, {.count = 3, .spacing = 1}), OptionError);
  CHECK_THROWS_AS(place_waypoints(problem, result, {.count = 1}), OptionError);
  CHECK_THROWS_AS(place_waypoints(problem, result, {.spacing = 0}), OptionError);
  CHECK_THROWS_AS(place_waypoints(problem, result, {.spacing = std::nan("")}), OptionError);
  CHECK_THROWS_AS(place_waypoints(problem, result, {.spacing = 1e-9}), OptionError);
  CHECK_THROWS_AS(place_waypoints(problem, Result{}, {.count = 3}), InputError);
}

}  // namespace leastcost
