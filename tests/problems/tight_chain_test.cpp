// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/tight_chain.hpp"

#include <Eigen/Cholesky>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include "problems/taut/polyline_length.hpp"
#include "problems/taut/pulled_chain.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

EuclideanManifold flat(int dimension) { return EuclideanManifold({.dimension = dimension}); }

class UnitSphere final : public EmbeddedManifold {
 public:
  UnitSphere() : EmbeddedManifold({3, 3, 2}) {}

 private:
  bool project_point(Eigen::Ref<VectorXd> x) const override {
    x.normalize();
    return true;
  }
  void tangent_basis(const VectorXd&, Eigen::Ref<Points> basis) const override { basis.setIdentity(); }
};

ObstacleWalls one_ball(const VectorXd& center, double radius) {
  return ObstacleWalls(center.size(), {make_ball({.center = center, .radius = radius})}, 0);
}

double clearance_of(const Walls& walls, const Points& x) {
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i + 1 < x.cols(); ++i) least = std::min(least, walls.clearance(x.col(i), x.col(i + 1)).lower);
  return least;
}

Points tight(const ConstraintManifold& domain, const Walls& walls, const MatrixXd& metric, const Points& start) {
  return tight_chain(domain, walls, metric, start, [&](const Points& x) { return clearance_of(walls, x) >= 0; },
                     {.gain = 1e-5}, {});
}

double length_under(const MatrixXd& metric, const Points& x) {
  const MatrixXd root = metric.llt().matrixU();
  return polyline_length(root * x);
}

/// From -2 e1 over a point beside the ball to 2 e1, in four sides.
Points over(int dimension, const VectorXd& middle) {
  Points x(dimension, 5);
  x.setZero();
  x(0, 0) = -2;
  x(0, 4) = 2;
  x.col(2) = middle;
  x.col(1) = (x.col(0) + x.col(2)) / 2;
  x.col(3) = (x.col(2) + x.col(4)) / 2;
  return x;
}

}  // namespace

TEST_CASE("tight chains: around a ball in two, three and seven dimensions as long as tangents and arc") {
  // Around a unit ball between points 2 from its centre, opposite: 2 sqrt(4 - 1) + pi - 2 acos(1/2).
  const double shortest = 2 * std::sqrt(3.0) + std::acos(-1.0) - 2 * std::acos(0.5);
  for (const int d : {2, 3, 7}) {
    CAPTURE(d);
    const ObstacleWalls walls = one_ball(VectorXd::Zero(d), 1);
    VectorXd middle = VectorXd::Constant(d, 0.3);
    middle[1] = 1.9;
    const Points x = tight(flat(d), walls, MatrixXd::Identity(d, d), over(d, middle));
    CHECK(clearance_of(walls, x) >= 0);
    CHECK(polyline_length(x) >= shortest);
    CHECK(polyline_length(x) == Approx(shortest).epsilon(1e-3));
    CHECK(x.col(0) == over(d, middle).col(0));
    CHECK(x.rightCols(1) == over(d, middle).rightCols(1));
  }
}

TEST_CASE("tight chains: nothing in the way is a straight line, under any metric") {
  const ObstacleWalls walls = one_ball(VectorXd::Constant(4, 9), 1);
  const MatrixXd metric = Eigen::Vector4d(1, 4, 0.25, 9).asDiagonal();
  const Points start = over(4, Eigen::Vector4d(0.5, 1, -1, 0.2));
  const Points x = tight(flat(4), walls, metric, start);
  CHECK(length_under(metric, x) == Approx(4).epsilon(1e-6));
}

TEST_CASE("tight chains: under a metric an ellipse is a circle") {
  // With y counted twice a path over the unit disc has to pass the ellipse (cos, 2 sin): it goes where that is least.
  const ObstacleWalls walls = one_ball(VectorXd::Zero(2), 1);
  const MatrixXd metric = Eigen::Vector2d(1, 4).asDiagonal();
  const Points start = over(2, Eigen::Vector2d(0, 1.8));
  const Points x = tight(flat(2), walls, metric, start);
  CHECK(clearance_of(walls, x) >= 0);
  // The least by dense polygons around the ellipse: tangents from (-2, 0) touch it at cos = -1/2, and the arc between.
  double arc = 0;
  constexpr int kPieces = 100000;
  const double from = std::acos(-0.5), to = std::acos(0.5);
  for (int k = 0; k < kPieces; ++k) {
    const double a = from + (to - from) * (k + 0.5) / kPieces;
    arc += std::hypot(std::sin(a), 2 * std::cos(a)) * (from - to) / kPieces;
  }
  const double tangents = 2 * std::hypot(1.5, 2 * std::sin(from));
  CHECK(length_under(metric, x) == Approx(arc + tangents).epsilon(1e-3));
}

TEST_CASE("tight chains: a disc on a turning body goes round a disc as a point goes round a larger one") {
  // A disc that does not care how it turns: the radii add up, and the turn is taken evenly at no cost of its own.
  const auto robot = make_rigid_body({.shape = (MatrixXd(1, 5) << 0, 0, 0, 0, 0.5).finished()});
  const auto walls = std::make_shared<const RobotWalls>(
      robot, RobotWalls::Obstacles{make_ball({.center = Eigen::Vector2d(0, 0), .radius = 0.5})}, 0);
  const Points x =
      tight(flat(3), *walls, Eigen::Vector3d(1, 1, 0.01).asDiagonal(), over(3, Eigen::Vector3d(0, 1.9, 0.7)));
  CHECK(clearance_of(*walls, x) >= 0);
  const double shortest = 2 * std::sqrt(3.0) + std::acos(-1.0) - 2 * std::acos(0.5);
  CHECK(polyline_length(x.topRows(2)) == Approx(shortest).epsilon(1e-3));
}

TEST_CASE("tight chains: never longer, never through, within bounds, among random balls") {
  test::Random random(11);
  int shorter = 0;
  for (int k = 0; k < 40; ++k) {
    const int d = 2 + k % 4;
    ObstacleWalls::Obstacles balls;
    for (int i = 0; i < 12; ++i) {
      VectorXd center(d);
      for (int j = 0; j < d; ++j) center[j] = random.uniform(-1, 1);
      balls.push_back(make_ball({.center = center, .radius = random.uniform(0.1, 0.4)}));
    }
    const ObstacleWalls walls(d, balls, 0);
    const EuclideanManifold box({.dimension = d, .box = {VectorXd::Constant(d, -2), VectorXd::Constant(d, 2)}});
    Points start(d, 8);
    for (Index i = 0; i < start.cols(); ++i)
      for (int j = 0; j < d; ++j) start(j, i) = random.uniform(-2, 2);
    const bool clear = clearance_of(walls, start) >= 0;
    const Points x = tight(box, walls, MatrixXd::Identity(d, d), start);
    CAPTURE(k, d, clear);
    CHECK(polyline_length(x) <= polyline_length(start));
    CHECK(x.cwiseAbs().maxCoeff() <= 2 + 1e-12);
    if (clear || x.cols() != start.cols() || x != start) CHECK(clearance_of(walls, x) >= 0);
    shorter += polyline_length(x) < 0.9 * polyline_length(start) ? 1 : 0;
  }
  CHECK(shorter >= 5);
}

TEST_CASE("tight chains: what is refused is not returned, and late ones come back as they were") {
  const ObstacleWalls walls = one_ball(VectorXd::Zero(2), 1);
  const EuclideanManifold plane = flat(2);
  const Points start = over(2, Eigen::Vector2d(0, 1.9));
  const auto refuse = [](const Points&) { return false; };
  CHECK(tight_chain(plane, walls, MatrixXd::Identity(2, 2), start, refuse, {}, {}) == start);
  Monitor late;
  late.deadline = Monitor::Clock::now() - std::chrono::seconds(1);
  const auto accept = [](const Points&) { return true; };
  CHECK(tight_chain(plane, walls, MatrixXd::Identity(2, 2), start, accept, {}, late) == start);
  const Points nowhere = Points::Ones(2, 3);
  CHECK(tight_chain(plane, walls, MatrixXd::Identity(2, 2), nowhere, accept, {}, {}) == nowhere);
}

TEST_CASE("tight chains: parts that do not fit are refused") {
  const ObstacleWalls walls = one_ball(VectorXd::Zero(3), 1);
  const Points start = over(3, Eigen::Vector3d(0, 1.9, 0));
  const MatrixXd identity = MatrixXd::Identity(3, 3);
  CHECK_THROWS_AS(PulledChain(flat(2), walls, identity, start, 0, {}), InputError);
  CHECK_THROWS_AS(PulledChain(flat(3), walls, MatrixXd::Identity(2, 2), start, 0, {}), InputError);
  CHECK_THROWS_AS(PulledChain(flat(3), walls, identity, Points::Ones(3, 3), 0, {}), InputError);
  CHECK_THROWS_AS(PulledChain(UnitSphere(), walls, identity, start, 0, {}), InputError);
}

}  // namespace leastcost
