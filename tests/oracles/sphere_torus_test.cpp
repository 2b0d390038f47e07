// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Geodesics and loops on smooth surfaces that are defined in the tests, docs/oracles.md D1 and D2.
#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

const Eigen::Vector3d kFrom(0.925416578398323353, 0.336824088833465174, 0.173648177666930349);
const Eigen::Vector3d kTo(-0.413175911166534826, 0.49240387650610403, 0.766044443118978035);

Problem on_sphere(std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>()) {
  return between(std::make_shared<Sphere>(), make_euclidean_cost(3), kFrom, kTo, std::move(kernel));
}

/// m points of a closed curve t -> x(t), t in [0, 2 pi), as an initializer.
template <class Curve>
WaypointsInitializer loop(int m, Curve curve) {
  Points points(3, m);
  for (Index i = 0; i < m; ++i) points.col(i) = curve(2 * kPi * static_cast<double>(i) / m);
  return WaypointsInitializer(points);
}

Problem ring_on(std::shared_ptr<const ConstraintManifold> manifold) {
  return closed(std::move(manifold), make_euclidean_cost(3));
}

}  // namespace

TEST_CASE("D1: a geodesic of the sphere", "[oracle]") {
  const int n = GENERATE(7, 15, 32, 64, 200);
  const Result result = find(on_sphere(), n);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - 1.6543777367571768) <= e.error);
  CHECK(spread(result.costs) < 1e-6);
}

TEST_CASE("D1: the discrete minimisers on the sphere are equal chords, to the published digits", "[oracle]") {
  struct Row {
    int segments;
    double length, expm1;
  };
  for (const Row& row :
       {Row{8, 1.6514314117318846, 0.348270931615453616}, Row{16, 1.6536408601247952, 0.171824063011953516},
        Row{64, 1.65433167619714353, 0.0427769972364089259}}) {
    CAPTURE(row.segments);
    const Newton newton;
    FindOptions options;
    options.points = row.segments - 1;
    options.reference_cost = 1;
    options.certificate.enabled = false;
    const Result result = find_path(on_sphere(), StraightInitializer(), newton, options);
    CHECK(result.costs.sum() == Approx(row.length).epsilon(1e-13));
    CHECK(result.solve.final_energy == Approx(row.expm1).epsilon(1e-13));
    if (row.segments != 8) continue;
    const Result square = find_path(on_sphere(make_kernel<Square>()), StraightInitializer(), newton, options);
    CHECK(square.solve.final_energy == Approx(0.340903213456845671).epsilon(1e-13));
  }
}

TEST_CASE("D1: geodesics of the torus", "[oracle]") {
  const int n = GENERATE(15, 32, 64, 200);
  struct Row {
    double u0, v0, u1, v1, length;
  };
  const Row row = GENERATE(Row{0, 0, 1, 2, 3.00530920550149849}, Row{0, 0, 0.5, 3, 3.11354377379390939});
  const Problem problem =
      between(std::make_shared<Torus>(), make_euclidean_cost(3), Torus::at(row.u0, row.v0), Torus::at(row.u1, row.v1));
  const Eigen::Vector3d middle = Torus::at((row.u0 + row.u1) / 2, (row.v0 + row.v1) / 2);
  const Result result = find(problem, n, WaypointsInitializer(middle));
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, row.length, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - row.length) <= e.error);
}

TEST_CASE("D2: the inner equator of the torus is a certified minimum", "[oracle]") {
  const int n = GENERATE(16, 32, 33, 64, 200);
  const auto start = loop(40, [](double t) { return Torus::at(t, kPi + 0.5 * std::sin(2 * t)); });
  const Result result = find(ring_on(std::make_shared<Torus>()), n, start);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - 2 * kPi) <= e.error);
  CHECK(result.costs.sum() == Approx(2 * n * std::sin(kPi / n)).epsilon(1e-12));
  CHECK(result.certificate.index.verdict == IndexVerdict::minimum);
}

TEST_CASE("D2: the outer equator is a saddle of order 3, a meridian is degenerate", "[oracle]") {
  const int n = GENERATE(32, 64);
  CAPTURE(n);
  const Problem problem = ring_on(std::make_shared<Torus>());
  const Result outer = find(problem, n, loop(n, [](double t) { return Torus::at(t, 0); }));
  CAPTURE(failures(outer.certificate));
  CHECK(outer.status == Status::uncertified);
  CHECK(failed(outer.certificate, "saddle"));
  CHECK(outer.certificate.index.saddle_order == 3);
  const Result meridian = find(problem, n, loop(n, [](double t) { return Torus::at(0.3, t); }));
  CAPTURE(failures(meridian.certificate));
  CHECK(meridian.status == Status::uncertified);
  CHECK(failed(meridian.certificate, "degenerate"));
}

TEST_CASE("D2: contractible rings collapse, and say so", "[oracle]") {
  SECTION("in the plane") {
    Points points(2, 5);
    points << 0, 2, 3, 1, -1, 0, -1, 1, 2, 1;
    const Result result = find(closed(space(2), make_euclidean_cost(2)), 24, WaypointsInitializer(points));
    CHECK(result.solve.termination == Termination::collapsed);
    CHECK(result.status == Status::collapsed);
    CHECK(result.costs.sum() < 1e-5);
  }
  SECTION("on the sphere") {
    const auto start =
        loop(24, [](double t) { return Eigen::Vector3d(std::cos(t), std::sin(t), 0.7 + 0.1 * std::cos(3 * t)); });
    const Result result = find(ring_on(std::make_shared<Sphere>()), 24, start);
    CHECK(result.solve.termination == Termination::collapsed);
    CHECK(result.status == Status::collapsed);
  }
}

TEST_CASE("D2: a great circle is a closed geodesic, and a saddle", "[oracle]") {
  const auto start = loop(32, [](double t) { return Eigen::Vector3d(std::cos(t), std::sin(t), 0); });
  const Result result = find(ring_on(std::make_shared<Sphere>()), 32, start);
  CAPTURE(failures(result.certificate), word_of(result.solve.termination));
  CHECK(result.status == Status::uncertified);
  CHECK(failed(result.certificate, "saddle"));
}

}  // namespace leastcost::test
