// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Problems on which the certificate once believed what was not so: bars that a lucky difference made too small, chains
// that jump around a hole, a neck or an apex in one segment, boxes that chords ignore, saddles that few points hide.
#include <cmath>
#include <numbers>

#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

Result on_chart(const ParametricOptions& surface, const Vector2d& source, const Vector2d& target, int n,
                std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>()) {
  return find(between(make_parametric_manifold(surface), make_euclidean_cost(3), source, target, std::move(kernel)), n);
}

ParametricOptions annulus(double hole) {
  ParametricOptions options{.surface = parametric::Formula{.x = "u*cos(v)", .y = "u*sin(v)", .z = "0"}};
  options.box = {Vector2d(hole, -50), Vector2d(9, 50)};
  return options;
}

/// A certified value is covered by its bar; one that is not certified may be anything.
void check_honest(const Result& result, double truth) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(e.value, e.error, e.method, truth, failures(result.certificate));
  if (result.status == Status::certified) CHECK(std::abs(e.value - truth) <= e.error);
}

}  // namespace

TEST_CASE("a chain that jumps around a hole of its chart in one segment is refused", "[oracle]") {
  // By v the way to 3.6 leads around the hole; the straight chord on the other side is shorter than that.
  CHECK(failed(on_chart(annulus(0.01), {1, 0}, {1.3, 3.6}, 64).certificate, "longest_segment"));
  const ParametricOptions thin{
      .surface = parametric::Torus{.major_radius = 1.01, .minor_radius = 1}};  // a hole of radius 0.01
  CHECK(failed(on_chart(thin, {0, 2}, {5, 4}, 33).certificate, "longest_segment"));
}

TEST_CASE("around the apex of a cone: refused with few points, the law of cosines with many", "[oracle]") {
  const ParametricOptions surface{.surface = parametric::Cone{.half_angle = 0.5}};
  CHECK(failed(on_chart(surface, {0, 1}, {6, 1.3}, 12).certificate, "longest_segment"));
  const Result fine = on_chart(surface, {0, 1}, {6, 1.3}, 200);
  CHECK(fine.status == Status::certified);
  check_honest(fine, std::sqrt(1 + 1.69 - 2.6 * std::cos(6 * std::sin(0.5))));
}

TEST_CASE("a chain that hugs a small hole has a bar that is worth something, or no certificate", "[oracle]") {
  const double r = 0.03;
  // Two tangents and the arc between them.
  const double angle = 3.6 - std::acos(r / 1) - std::acos(r / 1.3);
  const double truth = std::sqrt(1 - r * r) + std::sqrt(1.69 - r * r) + r * angle;
  const int n = GENERATE(100, 400, 1600);
  const Result result = on_chart(annulus(r), {1, 0}, {1.3, 3.6}, n);
  check_honest(result, truth);
  CHECK((n == 100 ? failed(result.certificate, "bracket") : result.status == Status::certified));
}

TEST_CASE("under a lid on a sphere the value is covered at few points", "[oracle]") {
  // The way over the pole is closed at z = lid: two great circles that touch the parallel, and the arc between them.
  const double lid = 0.9999417202299663;
  const Eigen::Vector3d source(0.817770459769109, 0, 0.5755445031698417),
      target(-0.030652702166226576, 0.005505896077611216, 0.9995149308330972);
  ImplicitManifoldOptions options{.surface = implicit::Sphere{}};
  options.box = {Eigen::Vector3d::Constant(-2), Eigen::Vector3d(2, 2, lid)};
  const double polar = std::acos(lid);
  const auto to_parallel = [&](const Eigen::Vector3d& x) {
    const double theta = std::acos(x.z());
    return std::pair(std::acos(std::cos(theta) / std::cos(polar)), std::acos(std::tan(polar) / std::tan(theta)));
  };
  const auto [length_a, azimuth_a] = to_parallel(source);
  const auto [length_b, azimuth_b] = to_parallel(target);
  const double between_ends = std::acos(source.head<2>().normalized().dot(target.head<2>().normalized()));
  const double truth = length_a + length_b + std::sin(polar) * (between_ends - azimuth_a - azimuth_b);
  CHECK(truth == Approx(0.98868692).epsilon(1e-8));
  const int n = GENERATE(6, 20, 60);
  const Result result = find(between(make_implicit_manifold(options), make_euclidean_cost(3), source, target), n,
                             WaypointsInitializer(Eigen::Vector3d(0.02, 0.03, 0.9993)));
  check_honest(result, truth);
  CHECK(result.status == Status::certified);
}

TEST_CASE("two equal levels by luck do not make a small bar", "[oracle]") {
  const ParametricOptions torus{.surface = parametric::Torus{}};
  const auto [target, truth] =
      GENERATE(std::pair(Vector2d(1, 2), 3.00530920550149849),  // docs/oracles.md D1, torus a and b
               std::pair(Vector2d(0.5, 3), 3.11354377379390939));
  const auto kernel = GENERATE(make_kernel<Square>(), make_kernel<Expm1Square>());
  const int step = nightly() ? 1 : 3;
  int certified = 0;
  for (int n = 3; n <= 40; n += step) {
    CAPTURE(n, target.transpose());
    const Result result = on_chart(torus, {0, 0}, target, n, kernel);
    check_honest(result, truth);
    certified += result.status == Status::certified ? 1 : 0;
  }
  CHECK(certified >= 25 / step);
}

TEST_CASE("a ring around an elliptic neck is covered at every number of points", "[oracle]") {
  const double truth = 4 * std::comp_ellint_2(std::sqrt(1 - 0.49));  // the waist, an ellipse 1 : 0.7
  const ImplicitManifoldOptions options{.surface = implicit::Formula{.f = "x^2 + y^2/0.49 - z^2 - 1"}};
  const Problem problem = closed(make_implicit_manifold(options), make_euclidean_cost(3));
  Points loop(3, 12);
  for (Index i = 0; i < 12; ++i) {
    const double t = 2 * kPi * static_cast<double>(i) / 12;
    loop.col(i) = Eigen::Vector3d(std::cos(t), 0.7 * std::sin(t), 0.1 * std::sin(2 * t));
  }
  int certified = 0;
  for (int n = 12; n <= 40; n += 4) {
    CAPTURE(n);
    const Result result = find(problem, n, WaypointsInitializer(loop));
    check_honest(result, truth);
    certified += result.status == Status::certified ? 1 : 0;
  }
  CHECK(certified >= 4);
}

TEST_CASE("an equator beyond its conjugate point is a saddle however few the points", "[oracle]") {
  // Along the equator of an ellipsoid 1:1:1.3 the curvature is 1 / 1.3^2: conjugate at 1.3 pi, and the path is a little
  // longer.
  const ParametricOptions options{.surface = parametric::Ellipsoid{.axes = Eigen::Vector3d(1, 1, 1.3)}};
  const int n = GENERATE(range(2, 8));
  const Problem problem = between(make_parametric_manifold(options), make_euclidean_cost(3), Vector2d(0, 0),
                                  Vector2d(1.003 * 1.3 * kPi, 0));
  FindOptions given;
  given.points = n;
  given.certificate.refine = 0;
  given.target_as_given = true;  // not the shorter way round
  const Result result = find_path(problem, StraightInitializer(), Newton(), given);
  CAPTURE(n, failures(result.certificate));
  CHECK(result.status != Status::certified);
}

}  // namespace leastcost::test
