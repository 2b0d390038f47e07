// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <numbers>

#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/trials.hpp"

// docs/oracles.md D1 and D2 in charts. The reported value is that of a cubic curve through the points on the surface,
// order 4 in the step: at 200 points at most 1e-8 (relative), where the chain alone has 1e-5.
namespace leastcost::test {
namespace {

struct SurfaceRow {
  const char* name;
  parametric::Surface surface;
  Eigen::Vector2d source, target;
  double length;
};

std::vector<SurfaceRow> rows() {
  const double f = 1 / 298.257223563, a = 6378137;
  const parametric::Ellipsoid wgs84{Eigen::Vector3d(a, a, a * (1 - f))}, oblate{Eigen::Vector3d(1, 1, 0.5)},
      prolate{Eigen::Vector3d(1, 1, 2)};
  const auto reduced = [f](double latitude) { return std::atan((1 - f) * std::tan(latitude * kDegree)); };
  const parametric::Cone cone{30 * kDegree};
  parametric::Formula formula;
  formula.x = "(R + r * cos(v)) * cos(u)";
  formula.y = "(R + r * cos(v)) * sin(u)";
  formula.z = "r * sin(v)";
  formula.parameters = {{"R", 2}, {"r", 1}};
  formula.period_u = formula.period_v = 2 * kPi;
  return {
      {"sphere", parametric::Sphere{}, {20 * kDegree, 10 * kDegree}, {130 * kDegree, 50 * kDegree}, 1.6543777367571768},
      {"wgs84", wgs84, {-73.8 * kDegree, reduced(40.6)}, {-0.5 * kDegree, reduced(51.6)}, 5551759.40031867851},
      {"wgs84-b", wgs84, {0, reduced(-30)}, {100 * kDegree, reduced(45)}, 13041867.3355196569},
      {"oblate", oblate, {0, -30 * kDegree}, {80 * kDegree, 40 * kDegree}, 1.45367223192944649},
      {"prolate", prolate, {0, -30 * kDegree}, {80 * kDegree, 40 * kDegree}, 2.66567376469373296},
      {"triaxial",
       parametric::Ellipsoid{},
       {10 * kDegree, 20 * kDegree},
       {70 * kDegree, -30 * kDegree},
       2.7185442772832},
      {"torus-a", parametric::Torus{}, {0, 0}, {1, 2}, 3.00530920550149849},
      {"torus-b", parametric::Torus{}, {0, 0}, {0.5, 3}, 3.11354377379390939},
      {"torus-a by formulas", formula, {0, 0}, {1, 2}, 3.00530920550149849},
      {"cone", cone, {0, 1}, {2, 2}, 1.68487114537802004},
      {"cylinder", parametric::Cylinder{}, {0, 0}, {2, 3}, 3.60555127546398929},
      {"catenoid", parametric::Catenoid{}, {0, -1}, {1, 1.5}, 3.54433036420273776},
      {"helicoid", parametric::Spiral{}, {-1.17520119364380146, 0}, {2.1292794550948175, 1}, 3.54433036420273776},
      {"hyperboloid", parametric::Hyperboloid{}, {0, 0}, {std::atan2(2, 1), 2}, 2.8284271247461901},
      {"paraboloid", parametric::Paraboloid{}, {0, 0.5}, {1, 2}, 2.65812797718534176},
  };
}

}  // namespace

TEST_CASE("oracles D1: geodesics in charts", "[oracle]") {
  const auto all = rows();
  const SurfaceRow& row = all[GENERATE_COPY(range(std::size_t{0}, all.size()))];
  CAPTURE(row.name);
  const Problem problem =
      between(make_parametric_manifold({.surface = row.surface}), make_euclidean_cost(3), row.source, row.target);
  for (const int n : share<int>({200, 64, 32}, 2)) {
    const Result result = find(problem, n);
    const CostEstimate& estimate = result.certificate.estimate;
    CAPTURE(n, estimate.value, estimate.error, estimate.method, failures(result.certificate), result.solve.iterations);
    CHECK(result.status == Status::certified);
    if (n == 200) CHECK(std::abs(estimate.value - row.length) <= 1e-8 * row.length);
    CHECK(std::abs(estimate.value - row.length) <= estimate.error + 1e-14 * row.length);
  }
}

}  // namespace leastcost::test
