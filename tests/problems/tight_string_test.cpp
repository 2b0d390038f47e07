// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Paths pulled tight in space: around a ball and over the edge of a wall by closed forms, off a balance that is not
// shortest, through a window; and the program behind them against its own definition.
#include "problems/taut/tight_string.hpp"

#include <cmath>
#include <memory>
#include <numbers>
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
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "problems/taut/string_program.hpp"
#include "problems/taut/unheld_bends.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStringExcess = 1e-6;

std::shared_ptr<const Obstacle> ball3(const Vector3d& center, double radius) { return make_ball({center, radius}); }
std::shared_ptr<const Obstacle> box3(const Vector3d& lower, const Vector3d& upper) {
  return make_box_obstacle({lower, upper});
}

Points line_through(const std::vector<Vector3d>& points) {
  Points columns(3, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Index>(i)) = points[i];
  return columns;
}

/// From a to b around a circle or sphere of radius r at the origin, on its near side or its far one: two tangents and
/// an arc.
template <class Vector>
double around(const Vector& a, const Vector& b, double r, bool far = false) {
  const double near = std::acos(a.dot(b) / (a.norm() * b.norm())), angle = far ? 2 * std::numbers::pi - near : near;
  const double turn = angle - std::acos(r / a.norm()) - std::acos(r / b.norm());
  return std::sqrt(a.squaredNorm() - r * r) + std::sqrt(b.squaredNorm() - r * r) + r * turn;
}

/// Certified, clear of everything, and as long as it should be.
void check_plan(ObstacleWalls::Obstacles obstacles, double clearance, const std::vector<Vector3d>& way, double length) {
  const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3});
  Problem problem;
  problem.manifold = std::make_shared<const FreeSpace>(space, std::move(obstacles), clearance);
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel(Expm1Square{});
  problem.source = {way.front()};
  problem.target = {way.back()};
  FindOptions options;
  options.points = 40;
  options.post_processors = {std::make_shared<const TautPostProcessor>()};
  const Points between = line_through({way.begin() + 1, way.end() - 1});
  const Result result = find_path(problem, WaypointsInitializer(between), NoSolver(), options);
  const Certificate& certificate = result.certificate;
  CAPTURE(certificate.estimate.value, certificate.estimate.error, length);
  for (const auto& failure : certificate.failures) UNSCOPED_INFO(failure.name() << ": " << failure.message);
  CHECK(result.status == Status::certified);
  CHECK(certificate.scope == Scope::local);
  REQUIRE(certificate.clearance);
  CHECK(certificate.clearance->proved);
  CHECK(std::abs(certificate.estimate.value - length) <= certificate.estimate.error);
  CHECK(certificate.estimate.error <= 10 * kStringExcess * length);
}

}  // namespace

TEST_CASE("tight strings: around a ball as long as two tangents and an arc") {
  const Vector3d a(-3, 0.2, 0.1), b(2.5, -0.3, 0.4);
  check_plan({ball3({0, 0, 0}, 1)}, 0.2, {a, {0, 0.3, 3}, b}, around(a, b, 1.2));
  // Far away from the origin, where coordinates have fewer digits; and a ball far smaller than a segment.
  const Vector3d far(1e4, -2e4, 3e3);
  check_plan({ball3(far, 1)}, 0.2, {far + a, far + Vector3d(0, 0.3, 3), far + b}, around(a, b, 1.2));
  const Vector3d c(-3, 1e-4, 0), d(3, 0, 5e-4);
  check_plan({ball3({0, 0, 0}, 0.01)}, 0, {c, {0, 0, 3}, d}, around(c, d, 0.01));
  check_plan({}, 0, {a, {0, 0, 3}, b}, (a - b).norm());
}

/// The vertices stand where they stand: the bend is not at the ball, nor are its neighbours where the string is held.
TEST_CASE("tight strings: the bar holds wherever a small ball is beside the string") {
  for (const double r : {0.003, 0.03})
    for (int k = 0; k < 40; ++k) {
      const double at = -2.7 + 5.4 * k / 39;
      const ObstacleWalls walls(3, {ball3({0, 0, 0}, r)}, 0);
      const Vector3d a(-3 - at, 0.3 * r, 0.1 * r), b(3 - at, 0, 0.2 * r);
      const auto string = tight_string(walls, line_through({a, {0, 0, 0.2}, b}), kStringExcess, {});
      CAPTURE(r, k);
      REQUIRE(string);
      CHECK(std::abs(string->length - around(a, b, r)) <= string->excess + 1e-13);
    }
}

TEST_CASE("tight strings: many obstacles in one place are one", "[slow_sanitized]") {
  const Vector3d a(-3, 0.2, 0.1), b(2.5, -0.3, 0.4);
  const ObstacleWalls walls(3, ObstacleWalls::Obstacles(test::nightly() ? 100 : 20, ball3({0, 0, 0}, 1)), 0.2);
  const auto string = tight_string(walls, line_through({a, {0, 0.3, 3}, b}), kStringExcess, {});
  REQUIRE(string);
  CHECK(string->length == Approx(around(a, b, 1.2)).epsilon(kStringExcess));
  CHECK(unheld_bends(walls, string->polyline).largest < 1e-3);
}

TEST_CASE("tight strings: over the edge of a wall, which is unrolled") {
  for (const double clearance : {1e-3, 0.05, 0.4}) {
    const Vector3d a(-2, -1, -1), b(3, -0.5, 2);
    const double flat = around(Vector2d(a.head(2)), Vector2d(b.head(2)), clearance, true);
    CAPTURE(clearance);
    check_plan({box3({0, -20, -40}, {0, 0, 40})}, clearance, {a, {-1, 2, 0}, {1, 1, -1}, b},
               std::hypot(flat, b.z() - a.z()));
  }
}

TEST_CASE("tight strings: through a window, bent by one of its sides") {
  const Vector3d a(-2, -1, -0.5), b(3, -0.5, 0.25);
  const double clearance = 0.1, flat = around(Vector2d(a.head(2)), Vector2d(b.head(2)), clearance, true);
  const ObstacleWalls::Obstacles window = {box3({0, -20, -40}, {0, 0, 40}), box3({0, 1, -40}, {0, 20, 40}),
                                           box3({0, 0, -40}, {0, 1, -1}), box3({0, 0, 1}, {0, 1, 40})};
  check_plan(window, clearance, {a, {0, 0.5, 0}, b}, std::hypot(flat, b.z() - a.z()));
}

TEST_CASE("tight strings: a balance that is not shortest is left") {
  const ObstacleWalls walls(3, {ball3({0, 0, 0}, 1)}, 0);
  const Vector3d a(-2, 0, 0.5), b(2, 0, 0.5);
  const auto string = tight_string(walls, line_through({a, {-1, 0, -3}, {1, 0, -3}, b}), kStringExcess, {});
  REQUIRE(string);
  CHECK(string->length == Approx(around(a, b, 1)).epsilon(kStringExcess));
  CHECK(string->polyline.row(2).minCoeff() > 0);
}

TEST_CASE("tight strings: what is not asked for is refused, what cannot be pulled stays") {
  const ObstacleWalls walls(3, {ball3({0, 0, 0}, 1)}, 0);
  CHECK_FALSE(tight_string(walls, line_through({{-2, 0, 0}, {2, 0, 0}}), kStringExcess, {}));  // goes through
  CHECK_FALSE(tight_string(walls, line_through({{-2, 0, 0}, {-2, 0, 0}}), kStringExcess, {}));
  Monitor late;
  late.deadline = Monitor::Clock::now();
  CHECK_THROWS_AS(tight_string(walls, line_through({{-2, 0, 0}, {0, 0, 3}, {2, 0, 0}}), kStringExcess, late),
                  Interrupted);
}

/// Bars that were false: in scene 26 where no vertices stand between two balls that a side touches, for it is held
/// between the planes of both, and in scene 36 where the string is not pulled aside once more at the end.
TEST_CASE("tight strings: among large balls the bar covers what a finer string gains") {
  test::Random random(7);
  int bent = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const Vector3d a(0, 5, 5), b(10, 5, 5);
    ObstacleWalls::Obstacles balls;
    while (balls.size() < 25) {
      const Vector3d center(random.uniform(0, 10), random.uniform(0, 10), random.uniform(0, 10));
      const double radius = random.uniform(0.4, 1.4);
      if ((center - a).norm() > radius && (center - b).norm() > radius) balls.push_back(ball3(center, radius));
    }
    if (scene % 10 != 6) continue;
    const auto space = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 3});
    Problem problem;
    problem.manifold = std::make_shared<const FreeSpace>(space, balls, 0);
    problem.cost = make_euclidean_cost(3);
    problem.kernel = make_kernel(Expm1Square{});
    problem.source = {a};
    problem.target = {b};
    const Points start = RrtInitializer().first_path(problem, {}).path.u;
    const ObstacleWalls walls(3, balls, 0);
    const auto string = tight_string(walls, start, kStringExcess, {});
    REQUIRE(string);
    const auto finer = tight_string(walls, string->polyline, kStringExcess / 10, {});
    REQUIRE(finer);
    bent += string->polyline.cols() > 12 ? 1 : 0;
    CAPTURE(scene, string->length, string->excess, finer->length);
    CHECK(string->excess <= 3 * kStringExcess * string->length);
    CHECK(string->length - finer->length <= string->excess + finer->excess);
  }
  CHECK(bent > 1);
}

TEST_CASE("tight strings: a bend that nothing holds is seen") {
  const ObstacleWalls walls(3, {ball3({0, 0, 0}, 1)}, 0);
  const Points bent = line_through({{-2, 0, 3}, {0, 0.2, 3}, {2, 0, 3}});
  const Unheld unheld = unheld_bends(walls, bent);
  CHECK(unheld.largest == Approx(2 * std::sin(std::atan(0.1))).epsilon(1e-3));
  const double length = 2 * std::hypot(2.0, 0.2);
  CHECK(unheld.gain == Approx(length - 4).epsilon(0.02));
  // A ball beside it that pushes the other way holds nothing; one within the bend does.
  CHECK(unheld_bends(ObstacleWalls(3, {ball3({0, 1.2, 3}, 1)}, 0), bent).largest > 0.1);
  const Points over = line_through({{-2, 0, 0}, {0, std::sqrt(2.0), 0}, {2, 0, 0}});
  const double r = 2 * std::sqrt(2.0) / std::hypot(2.0, std::sqrt(2.0));
  CHECK(unheld_bends(ObstacleWalls(3, {ball3({0, 0, 0}, r)}, 0), over).largest < 1e-6);
}

TEST_CASE("tight strings: least stretched between half-spaces, none beside it is less") {
  test::Random random(5);
  const auto energy = [](const Matrix3Xd& x, const Eigen::VectorXd& rest) {
    double sum = 0;
    for (Index i = 0; i + 1 < x.cols(); ++i) sum += (x.col(i + 1) - x.col(i)).squaredNorm() / (2 * rest[i]);
    return sum;
  };
  for (int k = 0; k < 20; ++k) {
    constexpr Index kVertices = 9;
    Matrix3Xd x(3, kVertices);
    for (Index i = 0; i < kVertices; ++i)
      x.col(i) =
          Vector3d(static_cast<double>(i) / (kVertices - 1), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
    const Eigen::VectorXd rest = (x.rightCols(kVertices - 1) - x.leftCols(kVertices - 1)).colwise().norm();
    std::vector<HalfSpace> half_spaces;
    for (int j = 0; j < 25; ++j) {
      const Index vertex = 1 + j % (kVertices - 2);
      const Vector3d normal =
          Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)).normalized();
      half_spaces.push_back({vertex, normal, normal.dot(x.col(vertex)) - random.uniform(0, 0.05)});
    }
    const Matrix3Xd y = least_stretched(x, rest, half_spaces);
    const auto within = [&](const Matrix3Xd& z, double slack) {
      for (const HalfSpace& h : half_spaces)
        if (h.normal.dot(z.col(h.vertex)) < h.offset - slack) return false;
      return true;
    };
    CAPTURE(k);
    REQUIRE(within(y, 1e-11));
    const double least = energy(y, rest);
    CHECK(least < energy(x, rest));
    int tried = 0;
    for (int j = 0; j < 2000; ++j) {
      Matrix3Xd z = y;
      const Index vertex = 1 + j % (kVertices - 2);
      z.col(vertex) += 0.01 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (!within(z, 0)) continue;
      ++tried;
      CHECK(energy(z, rest) > least - 1e-9);
    }
    CHECK(tried > 50);
  }
}

}  // namespace leastcost
