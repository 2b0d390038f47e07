// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/clearance_length.hpp>

#include <cmath>
#include <memory>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

/// The index of refraction around a disc of radius 1 at the origin, and the derivative of its logarithm by the radius.
struct Lens {
  double weight, reach;
  std::pair<double, double> at(double r) const {
    const double s = std::max(0.0, 1 - (r - 1) / reach), n = 1 + weight * s * s * s;
    return {n, -3 * weight * s * s / reach / n};
  }
};

/// A ray (x, y, heading, cost) by its arc length: d heading / ds = (grad log n) . normal. Runge-Kutta of order 4 to
/// where it has come to the abscissa of the target.
Eigen::Vector4d ray(const Lens& lens, const Vector2d& from, double heading, double to_x) {
  using State = Eigen::Vector4d;
  const auto rate = [&](const State& s) -> State {
    const double r = std::hypot(s[0], s[1]);
    const auto [n, slope] = lens.at(r);
    const double normal = (-std::sin(s[2]) * s[0] + std::cos(s[2]) * s[1]) / r;
    return {std::cos(s[2]), std::sin(s[2]), slope * normal, n};
  };
  const auto step = [&](const State& s, double h) -> State {
    const State a = rate(s), b = rate(s + h / 2 * a), c = rate(s + h / 2 * b), d = rate(s + h * c);
    return s + h / 6 * (a + 2 * b + 2 * c + d);
  };
  State s(from[0], from[1], heading, 0);
  constexpr double kStep = 1e-3;
  while (s[0] < to_x) {
    if (s.head<2>().norm() < 1 || s[3] > 100) return {to_x, -1, 0, 0};  // caught: too low
    const State next = step(s, kStep);
    if (next[0] >= to_x) break;
    s = next;
  }
  double low = 0, high = 2 * kStep;  // the last step, to the abscissa
  for (int k = 0; k < 60; ++k) (step(s, (low + high) / 2)[0] < to_x ? low : high) = (low + high) / 2;
  return step(s, low);
}

/// The cost of the ray between two points that passes above the disc.
double shot(const Lens& lens, const Vector2d& from, const Vector2d& to) {
  double low = 0.2, high = 1.2;
  for (int k = 0; k < 60; ++k) (ray(lens, from, (low + high) / 2, to[0])[1] < to[1] ? low : high) = (low + high) / 2;
  return ray(lens, from, low, to[0])[3];
}

}  // namespace

TEST_CASE("clearance length: around a disc it is the ray that shooting finds") {
  const Lens lens{6, 1.5};
  const Vector2d from(-3, 0.1), to(3, 0.3);
  const double truth = shot(lens, from, to);
  const auto plane = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{});
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(plane, FreeSpace::Obstacles{make_ball({Vector2d(0, 0), 1})}, 0);
  problem.cost = make_clearance_length({lens.weight, lens.reach}, 2, problem.manifold);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {from};
  problem.target = {to};
  double before = 0;
  for (const int points : {49, 99}) {
    FindOptions options;
    options.points = points;
    const Result result = find_path(problem, BowInitializer(BowOptions{.height = 0.3}), Newton(), options);
    for (const auto& failure : result.certificate.failures) UNSCOPED_INFO(failure.name() + ": " + failure.message);
    CAPTURE(points, truth, result.certificate.estimate.value, result.certificate.estimate.error);
    CHECK(result.status == Status::certified);
    CHECK(std::abs(result.certificate.estimate.value - truth) <= result.certificate.estimate.error);
    REQUIRE(result.certificate.clearance);
    CHECK(result.certificate.clearance->lower > 0.1);  // nothing touches: it is the cost that keeps away
    const double off = std::abs(result.curve.cost - truth);
    if (before > 0) CHECK(off < before / 2);
    before = off;
  }
}

TEST_CASE("clearance length: asks for obstacles") {
  const std::shared_ptr<const ConstraintManifold> plane =
      std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{});
  CHECK_THROWS_WITH(make_clearance_length({1, 1}, 2, plane), Catch::Contains("needs obstacles"));
  const auto walls =
      std::make_shared<const ObstacleWalls>(2, ObstacleWalls::Obstacles{make_ball({Vector2d(0, 0), 1})}, 0.0);
  CHECK_THROWS_AS(make_clearance_length({1, 0}, 2, walls), OptionError);
  CHECK_THROWS_AS(make_clearance_length({-1, 1}, 2, walls), OptionError);
  CHECK_THROWS_AS(make_clearance_length({1, 1}, 3, walls), InputError);
}

}  // namespace leastcost
