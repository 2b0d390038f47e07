// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// docs/oracles.md D2 in charts: rings that close on another image of their first point.
#include <numbers>

#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

Result loop(const char* surface, int coordinate, const Eigen::Vector2d& through, int n) {
  const Problem problem =
      closed(make_parametric_manifold({.surface = form<parametric::Surface>(surface)}), make_euclidean_cost(3));
  return find(problem, n, CoordinateCircleInitializer({coordinate, through, 1}));
}

void check_waist(const Result& result, int n) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - 2 * kPi) <= e.error);
  if (n >= 64) CHECK(std::abs(e.value - 2 * kPi) <= 1e-8 * 2 * kPi);
  CHECK(result.costs.sum() == Approx(2 * n * std::sin(kPi / n)).epsilon(1e-12));  // the N-gon
}

}  // namespace

TEST_CASE("D2: waists in charts are certified minima", "[oracle]") {
  const int n = GENERATE(32, 64, 200);
  check_waist(loop("torus", 0, {0.3, kPi - 0.4}, n), n);
  check_waist(loop("hyperboloid", 0, {0.3, 0.5}, n), n);
  check_waist(loop("catenoid", 0, {0.3, -0.4}, n), n);
}

TEST_CASE("D2: in a chart the outer equator is a saddle of order 3, a meridian degenerate", "[oracle]") {
  const Result outer = loop("torus", 0, {0.3, 0}, 64), meridian = loop("torus", 1, {0.3, 0.2}, 64);
  CAPTURE(failures(outer.certificate), failures(meridian.certificate));
  CHECK(outer.certificate.index.saddle_order == 3);
  CHECK(failed(outer.certificate, "saddle"));
  CHECK(outer.costs.sum() == Approx(3 * 2 * 64 * std::sin(kPi / 64)).epsilon(1e-10));
  CHECK(failed(meridian.certificate, "degenerate"));
  CHECK(meridian.costs.sum() == Approx(2 * 64 * std::sin(kPi / 64)).epsilon(1e-10));
}

TEST_CASE("D2: around a cylinder every circle is a geodesic, none of them a certified minimum", "[oracle]") {
  const int n = GENERATE(8, 16, 64, 200);
  const ParametricOptions options{.surface = parametric::Cylinder{}};
  const Problem problem = closed(make_parametric_manifold(options), make_euclidean_cost(3));
  Points through(2, 3);
  through << 0, 2, 4.5, 0.3, -0.2, 0.1;
  for (const Result& result :
       {find(problem, n, WaypointsInitializer(through)), loop("cylinder", 0, Eigen::Vector2d(0.3, 0.4), n)}) {
    CAPTURE(n, failures(result.certificate));
    CHECK(failed(result.certificate, "degenerate"));
    CHECK(result.certificate.index.nullity == 1);
    // With 8 points a level slides without end, and there is no bar beside that failure.
    const CostEstimate& e = result.certificate.estimate;
    CHECK((failed(result.certificate, "refinement") || std::abs(e.value - 2 * kPi) <= e.error));
  }
}

}  // namespace leastcost::test
