// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Eqs. (21), (22): the speed at mid-height is not the time of a straight chute from rest (docs/numerics.md
// Sec. 2.1). Reproduced, and its error made visible.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/support/catch.hpp"
#include "tests/support/chute_chain.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

// the true least time of (0, 0) -> (pi, -2), gravity 1

Result solve(TravelTimeRule rule, int n) {
  const Newton newton;
  FindOptions options;
  options.points = n;
  options.certificate.enabled = false;
  return find_path(bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(kPi, -2), 1, 0, rule, make_kernel<Square>()),
                   StraightInitializer(), newton, options);
}

/// Exact time of each move of a solved path: uniform acceleration between its ends.
Eigen::VectorXd true_times(const CoordinatePath& path) {
  return PathEnergy(bead(path.u.col(0), path.u.rightCols(1)), 1).costs(path);
}

}  // namespace

TEST_CASE("Eq. 21, 22: the midpoint rule is L / sqrt(2 g (y0 - mean height))", "[paper]") {
  TravelTimeOptions options;
  options.rule = TravelTimeRule::midpoint;
  const Eigen::Vector2d source(1, 3), a(1.5, 2), b(4, 1);
  const auto cost = make_travel_time_cost(options, 2, Eigen::VectorXd(source));
  CHECK(move_cost(*cost, a, b) == Approx((b - a).norm() / std::sqrt(2 * 9.80665 * (3 - 1.5))));
}

TEST_CASE("Eq. 21: the reported time lies below the true optimum, 4.9 % at n = 10, and is only O(1/n)", "[paper]") {
  const double at10 = solve(TravelTimeRule::midpoint, 10).costs.sum();
  const double chute = solve(TravelTimeRule::chute, 10).costs.sum();
  std::printf("Eq. 21, n = 10: midpoint rule %.6f (%.2f %%), chute rule %.6f (%+.3f %%), truth %.6f\n", at10,
              100 * (at10 / kPi - 1), chute, 100 * (chute / kPi - 1), kPi);
  CHECK(at10 / kPi - 1 == Approx(-0.049).margin(0.0005));
  CHECK(chute / kPi - 1 == Approx(0.00085).margin(0.00001));
  double before = std::abs(solve(TravelTimeRule::midpoint, 31).costs.sum() - kPi);
  for (const int segments : {64, 128, 256, 512}) {
    const double error = kPi - solve(TravelTimeRule::midpoint, segments - 1).costs.sum();
    CHECK(error > 0);
    CHECK(std::log2(before / error) == Approx(1).margin(0.05));
    before = error;
  }
}

TEST_CASE("Eq. 21: the first segment stays 34 to 37 % longer than the rest, at every n", "[paper]") {
  const auto excess = [](const Eigen::VectorXd& times) { return times[0] / times.tail(times.size() - 1).mean() - 1; };
  for (const int n : {10, 30, 100, 300, 1000}) {
    const Result result = solve(TravelTimeRule::midpoint, n);
    const Eigen::VectorXd chute = true_times(result.path);
    std::printf("Eq. 21, n = %4d: first segment %.1f %% longer by its own rule, %.1f %% by the exact time\n", n,
                100 * excess(result.costs), 100 * excess(chute));
    CHECK((excess(result.costs) > 0.335 && excess(result.costs) < 0.375));
    CHECK(excess(chute) > 0.8);
    CHECK(spread(true_times(solve(TravelTimeRule::chute, n).path)) < 1e-6);
  }
}

TEST_CASE("Eq. 8 does not expose it: the doubling ratio stays near 2", "[paper]") {
  for (const int n : {10, 31}) {
    const Result coarse = solve(TravelTimeRule::midpoint, n), fine = solve(TravelTimeRule::midpoint, 2 * n + 1);
    const double ratio = coarse.costs.squaredNorm() / fine.costs.squaredNorm();  // H = s^2
    std::printf("Eq. 8 on Eq. 21: E(%d) / E(%d) = %.3f\n", n + 1, 2 * n + 2, ratio);
    CHECK(std::abs(ratio / 2 - 1) < CertificateOptions().doubling);
    if (n == 31) CHECK(ratio == Approx(1.967).margin(0.0005));
  }
}

TEST_CASE("Eq. 21: the certificate does not pass it off as the true time", "[paper]") {
  const int n = GENERATE(10, 31, 63);
  const Result result = find(bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(kPi, -2), 1, 0, TravelTimeRule::midpoint), n);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, e.method, failures(result.certificate));
  CHECK((!result.certificate.certified() || std::abs(e.value - kPi) <= e.error));
}

}  // namespace leastcost::test
