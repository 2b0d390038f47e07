// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// docs/oracles.md D3: a hill n = 1 + 2 exp(-r^2) between two points. Two mirror minima; the straight line over the top
// is a saddle.
#include <cmath>
#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/hill.hpp"

namespace leastcost::test {
namespace {

Problem over_the_hill() {
  return between(space(2), make_segment_cost(Hill{}), Eigen::Vector2d(-2, 0), Eigen::Vector2d(2, 0));
}

}  // namespace

TEST_CASE("D3: around the hill on either side", "[oracle]") {
  const double side = GENERATE(1.0, -1.0);
  const int n = GENERATE(32, 64, 200);
  const Result result = find(over_the_hill(), n, WaypointsInitializer(Eigen::Vector2d(0, side)));
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - 6.030127200428) <= std::max(e.error, 1e-12 * e.value));
  // The apex is seen by the nearest points only; the cubic through three of them would be O(h^2) off.
  const double apex = (side * result.path.u.row(1)).maxCoeff();
  CHECK(apex == Approx(1.460981078).margin(36.0 / (n * n)));
}

TEST_CASE("D3: from the straight line over the top, escape_saddle finds a way around the hill", "[oracle]") {
  const Newton newton;
  FindOptions options;
  options.points = 31;
  options.escape_saddle = true;
  const Result result = find_path(over_the_hill(), StraightInitializer(), newton, options);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(failures(result.certificate), result.solve.iterations);
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.index.verdict == IndexVerdict::minimum);
  CHECK(std::abs(e.value - 6.030127200428) <= std::max(e.error, 1e-12 * e.value));
}

TEST_CASE("D3: the straight line over the top is refused as a saddle", "[oracle]") {
  const int n = GENERATE(15, 32, 64, 200);
  const Result result = find(over_the_hill(), n);
  CAPTURE(n, failures(result.certificate));
  CHECK(result.status == Status::uncertified);
  CHECK(failed(result.certificate, "saddle"));
  CHECK(result.path.u.row(1).cwiseAbs().maxCoeff() < 1e-9);
  CHECK(result.costs.sum() == Approx(4 + 2 * std::sqrt(std::numbers::pi) * std::erf(2.0)).epsilon(40.0 / (n * n)));
}

}  // namespace leastcost::test
