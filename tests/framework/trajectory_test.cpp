// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/trajectory/trajectory.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include "framework/trajectory/blended_path.hpp"
#include "framework/trajectory/time_optimal.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

Points random_polyline(std::mt19937& random, Index d, Index m) {
  std::uniform_real_distribution<double> any(-1, 1);
  return Points::NullaryExpr(d, m, [&] { return any(random); });
}

Eigen::VectorXd random_limits(std::mt19937& random, Index d) {
  std::uniform_real_distribution<double> any(0.2, 3);
  return Eigen::VectorXd::NullaryExpr(d, [&] { return any(random); });
}

BlendedPath rounded(const Points& x) { return BlendedPath(x, Eigen::VectorXd::Ones(x.cols() - 2)); }

double distance_to_polyline(const Points& line, const Eigen::VectorXd& x) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Index i = 0; i + 1 < line.cols(); ++i) {
    const Eigen::VectorXd way = line.col(i + 1) - line.col(i);
    const double t = std::clamp(way.dot(x - line.col(i)) / way.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (x - line.col(i) - t * way).norm());
  }
  return nearest;
}

/// A result that is this path, in the space of its coordinates.
struct Given {
  Problem problem;
  Result result;
  explicit Given(const Points& x) {
    problem.manifold =
        std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = static_cast<int>(x.rows())});
    result.path.u = result.curve.x = x;
  }
};

}  // namespace

TEST_CASE("trajectory: a straight line takes what is known, from rest to rest") {
  // Accelerated half of the way, slowed down the other half; with a cruise between where the velocity is limited.
  const double acceleration = 2, distance = 3;
  const Points line = (Points(2, 2) << 0, distance, 0, 0).finished();
  const double velocity = GENERATE(100.0, 1.5);
  const double known =
      velocity > 10 ? 2 * std::sqrt(distance / acceleration) : distance / velocity + velocity / acceleration;
  const Trajectory motion = make_trajectory(
      Given(line).problem, Given(line).result,
      {.velocity = Eigen::VectorXd::Constant(1, velocity), .acceleration = Eigen::VectorXd::Constant(1, acceleration)});
  CHECK(motion.duration == Approx(known).epsilon(1e-3));
  CHECK(motion.duration >= known * (1 - 1e-12));
  CHECK(motion.least_duration == Approx(known).epsilon(1e-12));
  CHECK(motion.deviation == 0);
  CHECK(motion.x.col(0) == line.col(0));
  CHECK((motion.x.rightCols(1) - line.col(1)).norm() < 1e-12);
  CHECK(motion.velocity.rightCols(1).norm() == 0);
}

TEST_CASE("trajectory: limits hold between the samples too, and one of them is nearly always met") {
  std::mt19937 random(5);
  for (int trial = 0; trial < 40; ++trial) {
    const Index d = 1 + trial % 7;
    const Points x = random_polyline(random, d, 2 + trial % 9);
    const Eigen::VectorXd fastest = random_limits(random, d), strongest = random_limits(random, d);
    Given given(x);
    const Trajectory motion = make_trajectory(given.problem, given.result,
                                              {.velocity = fastest, .acceleration = strongest, .interval = 1.7e-3});
    CAPTURE(trial, motion.duration);
    CHECK(motion.duration >= motion.least_duration * (1 - 1e-12));
    int idle = 0;
    for (Index k = 0; k < motion.time.size(); ++k) {
      const double v = (motion.velocity.col(k).array().abs() / fastest.array()).maxCoeff();
      const double a = (motion.acceleration.col(k).array().abs() / strongest.array()).maxCoeff();
      if (v > 1 + 1e-9 || a > 1 + 1e-9) FAIL("a limit is exceeded: " << v << ", " << a);
      if (v < 0.95 && a < 0.95) ++idle;
    }
    CHECK(idle < 0.03 * static_cast<double>(motion.time.size()));
    // Velocities are those of the places, accelerations those of the velocities.
    double off = 0;
    for (Index k = 0; k + 2 < motion.time.size(); ++k) {
      const double step = motion.time[k + 1] - motion.time[k];
      const Eigen::VectorXd mean = (motion.velocity.col(k) + motion.velocity.col(k + 1)) / 2;
      off = std::max(off, (motion.x.col(k + 1) - motion.x.col(k) - step * mean).norm());
    }
    CHECK(off < 1.7e-3 * 1.7e-3 * strongest.norm());
    for (Index k = 0; k < motion.time.size(); k += 7)
      CHECK(distance_to_polyline(x, motion.x.col(k)) <= motion.deviation + 1e-12);
  }
}

TEST_CASE("trajectory: more stations hardly make it quicker") {
  std::mt19937 random(6);
  for (int trial = 0; trial < 10; ++trial) {
    const Points x = random_polyline(random, 3, 8);
    const Eigen::VectorXd fastest = random_limits(random, 3), strongest = random_limits(random, 3);
    const double few = time_optimal(rounded(x), fastest, strongest, 500).duration();
    const double many = time_optimal(rounded(x), fastest, strongest, 20000).duration();
    CHECK(few == Approx(many).epsilon(0.02));
    CHECK(many < few * (1 + 1e-3));
  }
}

TEST_CASE("trajectory: a path back the way it came, and points that repeat") {
  const Points x = (Points(1, 5) << 0, 1, 1, 1, -0.5).finished();
  Given given(x);
  const Trajectory motion = make_trajectory(
      given.problem, given.result,
      {.velocity = Eigen::VectorXd::Constant(1, 1.0), .acceleration = Eigen::VectorXd::Constant(1, 4.0)});
  CHECK(std::isfinite(motion.duration));
  CHECK(motion.x.maxCoeff() <= 1);
  CHECK(motion.x.maxCoeff() >= 1 - motion.deviation - 1e-4);
  CHECK(motion.x.rightCols(1)(0, 0) == Approx(-0.5));
}

TEST_CASE("trajectory: the rounding of a polygon around a disc that it touches stays out of the disc") {
  const int corners = 12;
  const double half = std::numbers::pi / 24;
  Points x(2, corners);
  for (int i = 0; i < corners; ++i)
    x.col(i) << std::cos(2 * half * i) / std::cos(half), std::sin(2 * half * i) / std::cos(half);
  double least = 2;
  const BlendedPath path = rounded(x);
  for (const PathPiece& piece : path.pieces())
    for (int k = 0; k <= 50; ++k) least = std::min(least, piece.place(piece.from + piece.length() * k / 50).norm());
  CHECK(least >= 1 - 1e-12);
}

TEST_CASE("trajectory: what is refused") {
  const Points line = (Points(2, 3) << 0, 1, 2, 0, 1, 0).finished();
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  Given given(line);
  const auto refused = [&](const TrajectoryOptions& options, const char* why) {
    CHECK_THROWS_WITH(make_trajectory(given.problem, given.result, options), Catch::Contains(why));
  };
  refused({.velocity = one}, "needs limits of both velocity and acceleration");
  refused({.velocity = Eigen::VectorXd::Ones(3), .acceleration = one}, "one for each of the 2 coordinates");
  refused({.velocity = -one, .acceleration = one}, "greater than 0");
  refused({.velocity = one, .acceleration = one, .interval = 1e-9}, "longer interval");
  given.problem.ring = true;
  refused({.velocity = one, .acceleration = one}, "a ring has no ends");
  given.problem.ring = false;
  given.result.curve.x.resize(2, 0);
  refused({.velocity = one, .acceleration = one}, "no path");
  given.result.curve.x = Points::Zero(2, 4);
  refused({.velocity = one, .acceleration = one}, "no length");
  given.problem.manifold = make_implicit_manifold({.surface = implicit::Sphere{}});
  refused({.velocity = one, .acceleration = one}, "flat domain");
}

}  // namespace leastcost::test
