// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Loops with a fixed point, at which they may have a kink.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/straightened.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const ParametricManifold> chart(const char* type) {
  return make_parametric_manifold({.surface = form<parametric::Surface>(type)});
}

/// A ring that is held at a point.
Problem based(std::shared_ptr<const ConstraintManifold> manifold, const Eigen::VectorXd& base) {
  Problem problem = closed(std::move(manifold), make_euclidean_cost(3));
  problem.source = project_end(*problem.manifold, base);
  problem.based = true;
  return problem;
}

void check_length(const Result& result, double length, double relative) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.path.u.cols(), e.value, e.error, e.method, length, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - length) <= e.error + 1e-14 * length);
  CHECK(std::abs(e.value - length) <= relative * length);
}

/// The geodesic of the torus with radii 2 and 1 that leaves a point at tube angle `v0` towards the inner equator, turns
/// back at tube angle `turn` > v0 and is back at v0 after one turn about the axis, by Clairaut's relation r sin(angle)
/// = c with c = r(turn): du = c dv / (r sqrt(r^2 - c^2)), ds = r dv / sqrt(r^2 - c^2), r = 2 + cos v. With v = turn -
/// (turn - v0) t^2 the integrands are smooth.
struct Clairaut {
  double v0 = 0;
  std::pair<double, double> half(double turn) const {  // angle about the axis and length of half of the loop
    const double c = 2 + std::cos(turn), span = turn - v0;
    constexpr int kPieces = 2000;
    double angle = 0, length = 0;
    for (int i = 0; i < kPieces; ++i) {  // midpoint rule in two Gauss points
      for (const double g : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
        const double t = (i + g) / kPieces, below = span * t * t;
        // r - c = cos(turn - below) - cos(turn), without cancellation.
        const double gap = 2 * std::sin(turn - below / 2) * std::sin(below / 2), r = c + gap;
        const double dv = 2 * span * t / std::sqrt(gap * (r + c)) / (2 * kPieces);
        angle += c / r * dv;
        length += r * dv;
      }
    }
    return {angle, length};
  }
  double loop() const {
    double low = v0, high = kPi;
    for (int i = 0; i < 60; ++i) {
      const double turn = (low + high) / 2;
      (half(turn).first < kPi ? low : high) = turn;
    }
    return 2 * half(low).second;
  }
};

}  // namespace

TEST_CASE("a loop with a fixed point on a cylinder is a circle through it", "[oracle]") {
  const int n = GENERATE(20, 32, 64, 200);
  const Problem problem = based(chart("cylinder"), Eigen::Vector2d(5, 0.7));
  const Result result = find(problem, n, CoordinateCircleInitializer({0, Eigen::Vector2d(0.3, -0.4), 1}));
  check_length(result, 2 * kPi, 1e-6);
  CHECK_FALSE(result.path.ring);
  CHECK(result.path.u.col(0) == problem.source.u);
  CHECK((result.path.u.rightCols(1) - problem.source.u - Eigen::Vector2d(2 * kPi, 0)).norm() <= 1e-14);
}

TEST_CASE("a loop with a fixed point off the waist of a torus has a kink there", "[oracle]") {
  const double v0 = GENERATE(from_range(share<double>({2.2, 1.4}, 2)));
  const double length = Clairaut{v0}.loop();
  const Result in_chart = find(based(chart("torus"), Eigen::Vector2d(0.3, v0)), 199,
                               CoordinateCircleInitializer({0, Eigen::Vector2d(1, 2.9), 1}));
  check_length(in_chart, length, 1e-8);
  CHECK(length < 2 * kPi * (2 + std::cos(v0)));
  // At the fixed point it comes in under another angle than it leaves.
  const Points& u = in_chart.path.u;
  CHECK(u(1, 1) > v0 + 1e-3);
  CHECK(u(1, u.cols() - 2) > v0 + 1e-3);

  const ImplicitManifoldOptions torus{.surface = leastcost::implicit::Torus{}};
  const double r = 2 + std::cos(v0);
  const Result implicit = find(based(make_implicit_manifold(torus), Eigen::Vector3d(r, 0, std::sin(v0))), 199,
                               PlaneCutInitializer({Eigen::Vector3d(1, 0, 0.05), Eigen::Vector3d(0, 0, 1)}));
  check_length(implicit, length, 1e-8);
  CHECK(implicit.path.u.col(0) == implicit.path.u.rightCols(1));
}

TEST_CASE("a loop with a fixed point that nothing holds collapses onto it", "[oracle]") {
  Points around(2, 3);
  around << 0.4, 0.8, 0.1, 0.3, 1.0, 1.2;
  const Result result = find(based(chart("torus"), Eigen::Vector2d(0.3, 0.3)), 40, WaypointsInitializer(around));
  CHECK(result.status == Status::collapsed);
  CHECK(result.solve.termination == Termination::collapsed);
}

TEST_CASE("a loop with a fixed point on a mesh keeps its vertex", "[oracle]") {
  const auto tube = std::make_shared<const MeshManifold>(TriangleMesh(grid(24, 12, Closing::kRound, true)));
  const std::int32_t vertex = 12 * 5 + 4;  // on the inner half of the tube
  const Eigen::Vector3d base = tube->mesh().position(vertex);
  const auto loop = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    return find_straightened(based(tube, base), 60, PlaneCutInitializer({point, normal}));
  };
  // Around the axis, and around the tube.
  const Result waist = loop(Eigen::Vector3d(2, 0, 0.03), Eigen::Vector3d(0, 0.01, 1));
  CAPTURE(failures(waist.certificate));
  CHECK(waist.status == Status::certified);
  CHECK((waist.curve.x.col(0) - base).norm() == 0);
  CHECK((waist.curve.x.rightCols(1) - base).norm() == 0);
  CHECK(waist.curve.cost < 2 * kPi * base.head<2>().norm());
  CHECK(waist.curve.cost > 2 * 24 * std::sin(kPi / 24) * 2 * (1 - 1e-12));  // the polygon around the waist
  const Result meridian = loop(base, Eigen::Vector3d(-base.y(), base.x(), 0));
  CAPTURE(failures(meridian.certificate));
  CHECK(meridian.status == Status::certified);
  // Between the vertices the tube's section is narrower, by cos(pi / 24) in one direction.
  CHECK(meridian.curve.cost <= 2 * 12 * std::sin(kPi / 12) * (1 + 1e-12));
  CHECK(meridian.curve.cost >= 2 * 12 * std::sin(kPi / 12) * std::cos(kPi / 24));
}

TEST_CASE("a loop that shrinks to its fixed point on a mesh is reported", "[oracle]") {
  const auto ball = std::make_shared<const MeshManifold>(TriangleMesh(sphere(3)));
  const Result result =
      find_straightened(based(ball, ball->mesh().position(7)), 30,
                        PlaneCutInitializer({0.7 * ball->mesh().position(7), ball->mesh().position(7)}));
  CHECK(result.status == Status::collapsed);
}

}  // namespace leastcost::test
