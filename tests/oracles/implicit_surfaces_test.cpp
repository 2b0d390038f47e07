// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Geodesics of surfaces that are given as f(x, y, z) = 0 and of sets F(x) = 0: docs/oracles.md D1 and D3. The reported
// value is within its own error bar of the closed form at 32, 64 and 200 points, within 1e-8 (relative) at 200; in
// space no metric finer than the segments is left unseen (proved), and the bounds of the proof hold the closed form.
#include <cmath>
#include <numbers>

#include <leastcost/framework/domain/encloses_level_set.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/sample_domains.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const LevelSet> formula(const char* f, const std::map<std::string, double>& parameters = {}) {
  return make_implicit_manifold({.surface = leastcost::implicit::Formula{.f = f, .parameters = parameters}});
}

std::shared_ptr<const LevelSet> ellipsoid(double a, double b, double c) {
  return make_implicit_manifold({.surface = leastcost::implicit::Ellipsoid{Eigen::Vector3d(a, b, c)}});
}

std::shared_ptr<const LevelSet> level_set_named(const char* surface) {
  return make_implicit_manifold({.surface = form<leastcost::implicit::Surface>(surface)});
}

std::shared_ptr<const LevelSet> equations(int dimension, const std::vector<std::string>& texts) {
  ConstraintManifoldOptions options;
  options.dimension = dimension;
  options.equations = texts;
  return make_constraint_manifold(options);
}

/// Point of the ellipsoid with axes a, b, c at reduced latitude and longitude in degrees.
Eigen::Vector3d reduced(double a, double b, double c, double latitude, double longitude) {
  const double l = latitude * kDegree, w = longitude * kDegree;
  return {a * std::cos(l) * std::cos(w), b * std::cos(l) * std::sin(w), c * std::sin(l)};
}

/// Point of the WGS84 ellipsoid at geodetic latitude and longitude in degrees, metres.
constexpr double kEquator = 6378137, kPole = kEquator * (1 - 1 / 298.257223563);
Eigen::Vector3d geodetic(double latitude, double longitude) {
  const double l = latitude * kDegree, reduced_latitude = std::atan2(kPole * std::sin(l), kEquator * std::cos(l));
  return reduced(kEquator, kEquator, kPole, reduced_latitude / kDegree, longitude);
}

void check_proof(const Problem& problem, const Result& result, double exact) {
  REQUIRE(result.certificate.resolution);
  const Resolution& r = *result.certificate.resolution;
  if (find_ability<EnclosesLevelSet>(*problem.manifold) == nullptr) return;
  CHECK(r.verdict == ResolutionVerdict::proved);
  if (result.path.u.cols() > 60) CHECK(r.minimum_proved);
  if (!r.minimum_proved) return;
  CHECK(r.lower.value() <= exact * (1 + 1e-15));
  CHECK(exact * (1 - 1e-15) <= r.upper.value());
}

void check_length(const Problem& problem, double exact, const Initializer& initializer = StraightInitializer()) {
  for (const int n : share<int>({200, 64, 32}, 2)) {
    const Result result = find(problem, n, initializer);
    const CostEstimate& e = result.certificate.estimate;
    CAPTURE(n, exact, e.value, e.error, e.method, failures(result.certificate), result.solve.iterations);
    CHECK(result.status == Status::certified);
    CHECK(std::abs(e.value - exact) <= e.error + 1e-15 * exact);  // the closed forms have 15 to 18 digits
    if (n > 64) CHECK(std::abs(e.value - exact) <= 1e-8 * exact);
    CHECK(result.solve.iterations <= 20);  // independent of n
    check_proof(problem, result, exact);
  }
}

void check_length(std::shared_ptr<const ConstraintManifold> domain, const Eigen::VectorXd& from,
                  const Eigen::VectorXd& to, double exact) {
  const int d = static_cast<int>(from.size());
  check_length(between(std::move(domain), make_euclidean_cost(d), from, to), exact);
}

}  // namespace

TEST_CASE("D1 implicit: sphere", "[oracle]") {
  check_length(level_set_named("sphere"),
               Eigen::Vector3d(0.925416578398323353, 0.336824088833465174, 0.173648177666930349),
               Eigen::Vector3d(-0.413175911166534826, 0.49240387650610403, 0.766044443118978035), 1.6543777367571768);
}

TEST_CASE("D1 implicit: WGS84, in metres", "[oracle]") {
  check_length(ellipsoid(kEquator, kEquator, kPole), geodetic(40.6, -73.8), geodetic(51.6, -0.5), 5551759.40031867851);
  check_length(ellipsoid(kEquator, kEquator, kPole), geodetic(-30, 0), geodetic(45, 100), 13041867.3355196569);
}

TEST_CASE("D1 implicit: oblate, prolate and triaxial ellipsoids", "[oracle]") {
  check_length(ellipsoid(1, 1, 0.5), reduced(1, 1, 0.5, -30, 0), reduced(1, 1, 0.5, 40, 80), 1.45367223192944649);
  check_length(ellipsoid(1, 1, 2), reduced(1, 1, 2, -30, 0), reduced(1, 1, 2, 40, 80), 2.66567376469373296);
  check_length(ellipsoid(3, 2, 1), reduced(3, 2, 1, 20, 10), reduced(3, 2, 1, -30, 70), 2.7185442772832);
}

TEST_CASE("D1 implicit: torus", "[oracle]") {
  struct Row {
    double u, v, length;
  };
  for (const Row& row : {Row{1, 2, 3.00530920550149849}, Row{0.5, 3, 3.11354377379390939}}) {
    const Eigen::Vector3d middle = Torus::at(row.u / 2, row.v / 2);
    check_length(between(level_set_named("torus"), make_euclidean_cost(3), Torus::at(0, 0), Torus::at(row.u, row.v)),
                 row.length, WaypointsInitializer(middle));
  }
}

TEST_CASE("D1 implicit, formulas: cone, cylinder, catenoid", "[oracle]") {
  const auto on_cone = [](double l, double phi) {
    return Eigen::Vector3d(0.5 * l * std::cos(phi), 0.5 * l * std::sin(phi), std::sqrt(0.75) * l);
  };
  check_length(formula("x^2 + y^2 - z^2*tan(angle)^2", {{"angle", 30 * kDegree}}), on_cone(1, 0), on_cone(2, 2),
               1.68487114537802004);
  check_length(formula("x^2 + y^2 - 1"), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(std::cos(2), std::sin(2), 3),
               3.60555127546398929);
  const auto on_catenoid = [](double u, double v) {
    return Eigen::Vector3d(std::cosh(v) * std::cos(u), std::cosh(v) * std::sin(u), v);
  };
  check_length(formula("x^2 + y^2 - cosh(z)^2"), on_catenoid(0, -1), on_catenoid(1, 1.5), 3.54433036420273776);
}

TEST_CASE("D1 implicit, formulas: hyperboloid (a ruling) and paraboloid", "[oracle]") {
  check_length(formula("x^2 + y^2 - z^2 - 1"), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 2, 2), 2 * std::sqrt(2));
  const auto on_paraboloid = [](double r, double phi) {
    return Eigen::Vector3d(r * std::cos(phi), r * std::sin(phi), r * r / 2);
  };
  check_length(formula("z - (x^2 + y^2)/2"), on_paraboloid(0.5, 0), on_paraboloid(2, 1), 2.65812797718534176);
}

TEST_CASE("D2 implicit: the waists of hyperboloid and catenoid", "[oracle]") {
  const int n = GENERATE(32, 64, 200);
  for (const char* surface : {"x^2 + y^2 - z^2 - 1", "x^2 + y^2 - cosh(z)^2"}) {
    Points around(3, 24);
    for (Index i = 0; i < around.cols(); ++i) {
      const double t = 2 * kPi * static_cast<double>(i) / 24;
      around.col(i) = Eigen::Vector3d(std::cos(t), std::sin(t), 0.1 * std::sin(2 * t) + 0.05);
    }
    const Result result = find(closed(formula(surface), make_euclidean_cost(3)), n, WaypointsInitializer(around));
    const CostEstimate& e = result.certificate.estimate;
    CAPTURE(n, surface, e.value, e.error, e.method, failures(result.certificate));
    CHECK(result.status == Status::certified);
    CHECK(std::abs(e.value - 2 * kPi) <= e.error);
    CHECK(result.costs.sum() == Approx(2 * n * std::sin(kPi / n)).epsilon(1e-12));  // the N-gon
  }
}

TEST_CASE("D3: SO(3), the angle of Rz(1) Rx(1)", "[oracle]") {
  ConstraintManifoldOptions options;
  options.set = constraint::Rotations{};
  const double c = std::cos(0.5), s = std::sin(0.5);
  const Eigen::Vector4d one(1, 0, 0, 0), product(c * c, c * s, s * s, s * c);
  MetricTensorOptions metric;  // length between quaternions is half the angle: count it twice
  metric.matrix = 4 * Eigen::Matrix4d::Identity();
  check_length(between(make_constraint_manifold(options), make_metric_tensor_cost(metric, 4), one, product),
               1.38343648144209171);
}

TEST_CASE("level sets: great circles in R^7", "[oracle]") {
  ConstraintManifoldOptions options;
  options.set = constraint::Sphere{.radius = 2};
  options.dimension = 7;
  Eigen::VectorXd a(7), b(7);
  a << 1, 0, 1, 0, 1, 0, 1;  // norm 2
  b << -1, 1, 0, -1, 0, 1, 0;
  check_length(make_constraint_manifold(options), a, b, 2 * std::acos(a.dot(b) / 4));
}

TEST_CASE("level sets: products, a flat torus in R^4 and a sphere with a free coordinate", "[oracle]") {
  const auto on_torus = [](double s, double t) {
    return Eigen::Vector4d(std::cos(s), std::sin(s), 2 * std::cos(t), 2 * std::sin(t));
  };
  check_length(equations(4, {"x0^2 + x1^2 - 1", "x2^2 + x3^2 - 4"}), on_torus(0, 0), on_torus(1.5, -0.8),
               std::hypot(1.5, 1.6));
  check_length(equations(4, {"x0^2 + x1^2 + x2^2 - 1"}), Eigen::Vector4d(1, 0, 0, 0),
               Eigen::Vector4d(std::cos(2), 0, std::sin(2), 3), std::hypot(2, 3));
}

}  // namespace leastcost::test
