// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Least times of a bead, docs/oracles.md D4. Depths there are heights below the source here.
#include <cmath>
#include <numbers>

#include "framework/energy/spacing.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/chute_chain.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

struct Row {
  double x, y, gravity, time;  ///< across, down, length / s^2, s
};
const Row kFromRest[] = {
    {kPi, 2, 1, kPi},
    {kPi, 2, 9.81, 1.00303334035532372},
    {1, 1, 1, 1.82568218939666681},
    {1, 1, 9.81, 0.582895463154742641},
    {2, 1, 1, 2.52309998779289056},
    {2, 1, 9.81, 0.80556382951639893},
    {5, 1, 1, 4.34626868674840823},
    {5, 1, 9.81, 1.38765679693374665},
    {10, 5, 9.80665, 1.80160312245308},  // Dymos
};

Problem from_rest(const Row& row, const std::shared_ptr<const Kernel>& kernel = make_kernel<Expm1Square>()) {
  return bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(row.x, -row.y), row.gravity, 0, TravelTimeRule::chute, kernel);
}

/// A parabola from the source, its points crowded near one end as t^power.
CoordinatePath crowded(const Problem& problem, int points, double power) {
  CoordinatePath path{Points(2, points + 2), {}, false};
  for (Index i = 0; i < path.u.cols(); ++i) {
    const double t = std::pow(static_cast<double>(i) / (points + 1), power);
    path.u.col(i) = (1 - t) * problem.source.u + t * problem.target.u - Eigen::Vector2d(0, 2 * t * (1 - t));
  }
  return path;
}

}  // namespace

TEST_CASE("D4: a chain of chutes from rest takes T_N, all times equal", "[oracle]") {
  const Row row = GENERATE(from_range(std::begin(kFromRest), std::end(kFromRest)));
  const int n = GENERATE(10, 40, 160);
  const bool newton = GENERATE(true, false);
  CAPTURE(row.x, row.y, row.gravity, n, newton);
  const Newton first;
  const Lbfgs second;
  const Result result =
      find(from_rest(row), n, StraightInitializer(), newton ? static_cast<const Solver&>(first) : second);
  CHECK(result.costs.sum() == Approx(chute_chain_time(row.x, row.y, row.gravity, n + 1)).epsilon(1e-9));
  CHECK(spread(result.costs) < 1e-6);
  CHECK(result.costs.sum() > row.time);
}

TEST_CASE("D4: the closed form at N = 11 is the published one", "[oracle]") {
  CHECK(chute_chain_time(kPi, 2, 1, 11) == Approx(3.1442708063).epsilon(1e-10));
}

TEST_CASE("D4: equal times from badly spaced starts", "[oracle]") {
  const double power = GENERATE(0.3, 3.0, 8.0);
  const int n = GENERATE(10, 40, 160);
  CAPTURE(power, n);
  const Problem problem = from_rest(kFromRest[0], make_kernel<Square>());
  const Newton newton;
  const Lbfgs lbfgs;
  for (const Solver* solver : {static_cast<const Solver*>(&newton), static_cast<const Solver*>(&lbfgs)}) {
    CoordinatePath path = crowded(problem, n, power);
    PathEnergy energy(problem, PathEnergy(problem, 1).cost(path) / (n + 1));
    const SolveReport report = solver->solve(energy, path, {});
    CAPTURE(solver->name(), report.iterations, word_of(report.termination));
    CHECK(energy.cost(path) == Approx(chute_chain_time(kPi, 2, 1, n + 1)).epsilon(1e-9));
    CHECK(spread(energy.costs(path)) < 1e-6);
  }
}

TEST_CASE("D4: the chain falls to the cycloid's time at order 2, N^2 error -> 0.323", "[oracle]") {
  std::vector<double> errors;
  for (const int segments : {16, 32, 64, 128})
    errors.push_back(find(from_rest(kFromRest[0]), segments - 1).costs.sum() - kPi);
  for (std::size_t k = 1; k < errors.size(); ++k) CHECK(std::log2(errors[k - 1] / errors[k]) == Approx(2).margin(0.02));
  CHECK(128 * 128 * errors.back() == Approx(0.323).margin(1e-3));
}

TEST_CASE("D4: the certified value and its error cover the continuous optimum", "[oracle]") {
  const Row row = GENERATE(from_range(std::begin(kFromRest), std::end(kFromRest)));
  const int n = GENERATE(10, 15, 40, 63);
  const Result result = find(from_rest(row), n);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(row.x, row.y, row.gravity, n, failures(result.certificate), e.value, e.error, e.method);
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - row.time) <= e.error);
  CHECK(e.error < 0.01 * row.time);
  CHECK(result.certificate.index.verdict == IndexVerdict::minimum);
}

TEST_CASE("D4: a moving start has no singularity", "[oracle]") {
  const int n = GENERATE(10, 31, 64);
  const Problem problem = bead(Eigen::Vector2d(0, -0.5), Eigen::Vector2d(1, -1.5), 1, 1);  // v0 = sqrt(2 * 0.5)
  const Result result = find(problem, n);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, failures(result.certificate), e.value, e.error, e.method);
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - 1.02382628054580588) <= e.error);
  CHECK(spread(result.costs) < 1e-6);
}

TEST_CASE("D4: forward and backward take the same time", "[oracle]") {
  TravelTimeOptions options;
  options.gravity = 1;
  options.level = 0;
  const auto cost = make_travel_time_cost(options, 2, std::nullopt);
  const Eigen::Vector2d a(0, -0.5), b(1, -1.5);
  const double forward = find(between(space(2), cost, a, b), 32).costs.sum();
  CHECK(find(between(space(2), cost, b, a), 32).costs.sum() == Approx(forward).epsilon(1e-13));
}

}  // namespace leastcost::test
