// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Walking over inclined planes, docs/oracles.md D6: both directions, certified, and the truth within the bar.
#include <cmath>
#include <string>

#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/post_processors/switchbacks.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

/// Terrain over u, v in kilometres.
std::shared_ptr<const ConstraintManifold> terrain(const std::string& height) {
  ParametricOptions options;
  parametric::Formula formula;
  formula.x = "u", formula.y = "v", formula.z = height;
  options.surface = formula;
  return make_parametric_manifold(options);
}

Result walk(const std::string& height, const Eigen::Vector2d& from, const Eigen::Vector2d& to, int n,
            const Initializer& initializer = StraightInitializer(), WalkingOptions options = {}) {
  options.length = MapLength::kilometres;
  return find(between(terrain(height), make_walking_cost(options, 3), from, to), n, initializer);
}

void check_walk(const Result& result, double hours, double widest, Scope scope = Scope::local) {
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(result.costs.size(), hours, e.value, e.error, e.method, failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.scope == scope);
  CHECK(std::abs(e.value - hours) <= e.error * (1 + 1e-9));
  CHECK(e.error <= widest * hours);
  if (e.lower) CHECK(*e.lower <= hours * (1 + 1e-12));
  if (e.upper) CHECK(*e.upper >= hours * (1 - 1e-12));
}

const Eigen::Vector2d kHere(0, 0), kNorth(0, 1), kEast(1, 0), kNorthEast(1, 1);

}  // namespace

TEST_CASE("D6: gentle planes, walked straight", "[oracle]") {
  const int n = GENERATE(9, 64);
  const BowInitializer bow({.height = 0.15});
  check_walk(walk("0.2 * v", kHere, kEast, n, bow), 0.198541036102059687, 1e-11);
  check_walk(walk("0.2 * v", kHere, kNorth, n, bow), 0.399812548994516319, 1e-11);
  check_walk(walk("0.2 * v", kNorth, kHere, n, bow), std::exp(3.5 * 0.15) / 6, 1e-11);
  check_walk(walk("0.2 * v", kHere, kNorthEast, n, bow), 0.460606521901764535, 1e-11);
}

TEST_CASE("D6: steep planes, walked in switchbacks: the value is certified, the path is not unique", "[oracle]") {
  const int n = GENERATE(9, 64, 300);
  const BowInitializer bow({.height = 0.15});
  const double up = 0.944458358619405205, down = 0.665548556554380243;
  check_walk(walk("0.5 * v", kHere, kNorth, n, bow), up, 1e-3, Scope::local_value);
  check_walk(walk("0.5 * v", kNorth, kHere, n, bow), down, 1e-3, Scope::local_value);
  // Any way within the cone costs the same; 2 km of height per km of map cost as the height says.
  check_walk(walk("0.5 * v", kHere, {0.5, 1}, n, bow), up, 1e-3, Scope::local_value);
  const Result steep = walk("2 * v", kHere, kNorth, n, bow);
  check_walk(steep, 2 * 1.88891671723881041, 1e-3, Scope::local_value);
  REQUIRE(steep.certificate.regularization.has_value());
  CHECK(steep.certificate.regularization->free_share == Approx(1));
  CHECK(steep.notes.back().find("switchbacks up (100 % of the cost, at slope 0.286): the value is certified, but "
                                "the path is not unique") == 0);
  // Beside the cone it is walked straight.
  check_walk(walk("0.5 * v", kHere, {3, 1}, n), std::hypot(3, 1) * std::exp(3.5 * (0.5 / std::hypot(3, 1) + 0.05)) / 6,
             1e-11);
}

TEST_CASE("D6: at the kink of the law the bar has what rounding it costs", "[oracle]") {
  const double rounding = GENERATE(0.001, 0.01, 0.04);
  const WalkingOptions law{.rounding = rounding};
  const Result descent = walk("0.05 * v", kNorth, kHere, 20, StraightInitializer(), law);
  check_walk(descent, 1.0 / 6, 1.4 * rounding);
  CHECK(descent.certificate.regularization->below == Approx(descent.certificate.estimate.error).epsilon(1e-6));
  CHECK(walk("0", kHere, kEast, 20, StraightInitializer(), law).certificate.regularization->below == 0);
}

TEST_CASE("D6: a hill with its kinks and its steep parts: rounder laws agree within their bars", "[oracle]") {
  const Eigen::Vector2d west(-2, 0.1), east(2, 0.1);
  const std::string height = GENERATE("0.3 * exp(-u^2 - v^2)", "0.8 * exp(-u^2 - v^2)");
  const CostEstimate sharp =
      walk(height, west, east, 256, StraightInitializer(), WalkingOptions{.rounding = 0.002}).certificate.estimate;
  for (const double rounding : {0.01, 0.03}) {
    const Result result = walk(height, west, east, 64, StraightInitializer(), WalkingOptions{.rounding = rounding});
    const CostEstimate& round = result.certificate.estimate;
    CAPTURE(height, rounding, sharp.value, sharp.error, round.value, round.error, failures(result.certificate));
    CHECK(result.status == Status::certified);
    CHECK(round.value - round.error <= sharp.value);
    CHECK(sharp.value - sharp.error <= round.value + round.error);
    CHECK(round.error < 0.02 * round.value);
  }
}

TEST_CASE("D6: switchbacks drawn: legs of slope 2/7 that cost what the path costs", "[oracle]") {
  const double width = GENERATE(0.3, 0.02);
  const auto cost = make_walking_cost({.length = MapLength::kilometres}, 3);
  FindOptions options{.points = 40};
  options.post_processors = {std::make_shared<SwitchbackPostProcessor>(SwitchbackOptions{width})};
  const auto drawn = [&](const std::string& height, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return find_path(between(terrain(height), cost, from, to), StraightInitializer(), Newton(), options);
  };
  const Result climb = drawn("0.5 * v + 0.1 * u", kHere, {0.3, 1});
  CHECK(climb.status == Status::certified);
  double beside = 0;
  for (Index i = 0; i + 1 < climb.curve.x.cols(); ++i) {
    const Eigen::Vector3d d = climb.curve.x.col(i + 1) - climb.curve.x.col(i), x = climb.curve.x.col(i);
    CHECK(d[2] / d.head(2).norm() == Approx(2.0 / 7).epsilon(1e-9));
    CHECK(x[2] == Approx(0.5 * x[1] + 0.1 * x[0]).margin(1e-12));
    // Across the way on the map, from the straight line on which the path runs.
    beside = std::max(beside, std::abs(x[0] * 1 - x[1] * 0.3) / std::hypot(1, 0.3));
  }
  CHECK(beside <= width / 2 * (1 + 1e-9));
  CHECK(beside > 0.2 * width);
  CHECK(climb.curve.cost == Approx(0.53 * 1.88891671723881041).epsilon(2e-4));
  CHECK(climb.curve_costs.sum() == Approx(climb.curve.cost).epsilon(1e-12));
  CHECK(climb.curve_costs.maxCoeff() < 1.3 * climb.curve_costs.minCoeff());
  CHECK((climb.curve.x.leftCols(1) - Eigen::Vector3d(0, 0, 0)).norm() < 1e-14);
  CHECK((climb.curve.x.rightCols(1) - Eigen::Vector3d(0.3, 1, 0.53)).norm() < 1e-14);
  const Result gentle = drawn("0.2 * v", kHere, kNorth);
  CHECK(gentle.curve.x.cols() == 42);
  CHECK(Catch::Matchers::Contains("the path is nowhere steep enough").match(gentle.notes.front()));
}

TEST_CASE("D6: on a hill narrower switchbacks cost less", "[oracle]") {
  const auto cost = make_walking_cost({.length = MapLength::kilometres}, 3);
  const auto excess = [&](double width) {
    FindOptions options{.points = 48};
    options.post_processors = {std::make_shared<SwitchbackPostProcessor>(SwitchbackOptions{width})};
    const auto problem =
        between(terrain("0.8 * exp(-u^2 - v^2)"), cost, Eigen::Vector2d(0.2, 1), Eigen::Vector2d(0, 0.1));
    const Result result = find_path(problem, StraightInitializer(), Newton(), options);
    CHECK(result.status == Status::certified);
    return result.curve.cost / result.certificate.estimate.value - 1;
  };
  const double wide = excess(0.3), narrow = excess(0.05);
  CHECK(narrow < 0.2 * wide);
  CHECK(narrow < 1e-3);
  CHECK(narrow > 0);
}

TEST_CASE("D6: the same on a plane by its equation, and in seconds over metres", "[oracle]") {
  ImplicitManifoldOptions options;
  options.surface = implicit::Formula{.f = "z - 0.5 * y"};
  const auto plane = make_implicit_manifold(options);
  const auto cost = make_walking_cost({.law = walking::Tobler{.unit = WalkingTime::seconds}}, 3);
  const Result result = find(between(plane, cost, Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(200, 1000, 500)), 40);
  check_walk(result, 3600 * 0.944458358619405205, 1e-3, Scope::local_value);
  CHECK(cost->traits().unit == "s");
}

TEST_CASE("Minetti's energy on level ground, gentle and steep planes", "[oracle]") {
  const WalkingOptions law{.law = walking::Minetti{}};
  const auto per_metre = [](double s) { return ((((280.5 * s - 58.7) * s - 76.8) * s + 51.9) * s + 19.6) * s + 2.5; };
  const auto straight = [&](double s) { return 1000 * std::hypot(1, s) * per_metre(s); };
  check_walk(walk("0", kHere, kEast, 20, StraightInitializer(), law), 2500, 1e-11);
  check_walk(walk("0.15 * v", kHere, kNorth, 20, StraightInitializer(), law), straight(0.15), 1e-11);
  check_walk(walk("0.15 * v", kNorth, kHere, 20, StraightInitializer(), law), straight(-0.15), 1e-11);
  // The cheapest climb and descent per height, by brute force over the gradients that were measured.
  const auto least_per_height = [&](double sign) {
    double best = 0.2;
    for (const double step : {1e-4, 1e-7, 1e-10})
      for (double s = best - 1e3 * step, end = best + 1e3 * step; s <= end; s += step)
        if (s > 0 && s <= 0.45 && straight(sign * s) / s < straight(sign * best) / best) best = s;
    return straight(sign * best) / best;
  };
  const double climb = least_per_height(1), descent = least_per_height(-1);
  check_walk(walk("0.4 * v", kHere, kNorth, 20, StraightInitializer(), law), 0.4 * climb, 3e-3, Scope::local_value);
  check_walk(walk("0.4 * v", kNorth, kHere, 20, StraightInitializer(), law), 0.4 * descent, 3e-3, Scope::local_value);
}

}  // namespace leastcost::test
