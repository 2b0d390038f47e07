// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/search/bracket.hpp>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/problems/planted_media.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kOfTruth = 1e-13;  // relative rounding of the planted least cost itself

std::shared_ptr<const CostDensity> isotropic(const std::string& squared,
                                             const std::map<std::string, double>& parameters = {}) {
  return density_of(make_metric_field_cost({.field = metric::Formula{{squared, "0", squared}, parameters}}, 2));
}

AlignedBox2d box(double x0, double y0, double x1, double y1) { return {Vector2d(x0, y0), Vector2d(x1, y1)}; }

}  // namespace

/// Closed forms (docs/oracles.md), and gaps that the construction is built for.
TEST_CASE("bracket: media with known least costs", "[slow_sanitized]") {
  struct Case {
    const char* squared;
    Vector2d source, target;
    AlignedBox2d box;
    double cost;
  };
  const std::vector<Case> cases = {
      {"1", {-1, 0.3}, {1.2, -0.4}, box(-2, -2, 2, 2), std::hypot(2.2, 0.7)},
      {"(1 + 2 * exp(-x^2 - y^2))^2", {-2, 0}, {2, 0}, box(-3, -3, 3, 3), 6.030127200428},
      {"(2 / (1 + x^2 + y^2))^2", {0.5, -0.2}, {-0.7, 0.9}, box(-1.6, -1.2, 1.6, 2), 2.47561986411056569},
      {"1 / (1 + 0.5 * y)^2", {0, 0}, {4, 1}, box(-0.5, -0.5, 4.5, 4.5), 3.05937323665641694},
      {"1 / y^2", {0, 1}, {2, 3}, box(-1.2, 0.3, 2.8, 4.3), 1.49099630899480838},
  };
  for (const Case& c : cases) {
    CAPTURE(c.squared);
    const std::shared_ptr<const CostDensity> density = isotropic(c.squared);
    const Bracket found = bracket_least_cost(*density, c.box, c.source, c.target, kInfinite, {.max_cells = 512});
    CHECK(found.lower <= c.cost * (1 + 1e-12));
    CHECK(found.upper >= c.cost * (1 - 1e-12));
    CHECK(found.gap() <= 2e-4);
    CHECK(1 - found.lower / c.cost <= 1e-4);
    REQUIRE(found.way.cols() > 2);
    CHECK(found.way.leftCols(1) == c.source);
    CHECK(found.way.rightCols(1) == c.target);
  }
}

TEST_CASE("bracket: one of two ways, whichever is cheaper") {
  // A hill beside the straight line: the way down the field takes the side that costs less.
  const std::shared_ptr<const CostDensity> density = isotropic("(1 + 2 * exp(-x^2 - (y + 0.1)^2))^2");
  const Bracket found =
      bracket_least_cost(*density, box(-3, -3, 3, 3), Vector2d(-2, 0), Vector2d(2, 0), kInfinite, {.max_cells = 512});
  CHECK(found.way.row(1).maxCoeff() > 0.5);
  CHECK(found.way.row(1).minCoeff() > -0.1);
  CHECK(found.gap() <= 1e-4);
}

TEST_CASE("bracket: nothing is proved of what is not known") {
  const AlignedBox2d around = box(-1, -1, 1, 1);
  const Vector2d s(-0.5, 0), t(0.5, 0.1);
  // Not the same in all directions, but by formula: the bound is of the cheaper direction, and holds.
  const auto metric = density_of(make_metric_field_cost({.field = metric::Formula{{"1", "0", "4"}, {}}}, 2));
  const Bracket weak = bracket_least_cost(*metric, around, s, t, 1.1, {.max_cells = 128});
  CHECK(weak.lower > 0.9);
  CHECK(weak.lower <= std::hypot(1, 0.1));
  const auto skew = density_of(make_metric_field_cost({.field = metric::Formula{{"1", "0.1", "1"}, {}}}, 2));
  CHECK(bracket_least_cost(*skew, around, s, t, 2, {.max_cells = 128}).lower == 0);
  // A place in the box where the formula has no value: only the surroundings of an end prove something.
  CHECK(bracket_least_cost(*isotropic("log(x + 0.8)^2 + 1"), around, s, t, 10, {.max_cells = 128}).lower < 0.3);
  CHECK_THROWS_AS(bracket_least_cost(*metric, around, s, Vector2d(2, 0)), InputError);
  CHECK_THROWS_AS(bracket_least_cost(*metric, AlignedBox2d(), s, t), InputError);
}

TEST_CASE("bracket: stopped at any time it keeps what is proved") {
  const std::shared_ptr<const CostDensity> density = isotropic("(2 / (1 + x^2 + y^2))^2");
  for (int after : {0, 1, 3, 10, 30, 100, 200}) {
    int looks = 0;
    const BracketOptions options{.tolerance = 1e-9, .max_cells = 512, .stop = [&] { return ++looks > after; }};
    const Bracket found = bracket_least_cost(*density, box(-1.6, -1.2, 1.6, 2), Vector2d(0.5, -0.2),
                                             Vector2d(-0.7, 0.9), kInfinite, options);
    CHECK(found.stopped);
    CHECK(looks == after + 1);
    CHECK(found.lower <= 2.47561986411056569);
  }
}

namespace {

Problem in_box(const AlignedBox2d& box, const std::string& squared, const Vector2d& source, const Vector2d& target) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(
      EuclideanManifoldOptions{2, {Eigen::VectorXd(box.min()), Eigen::VectorXd(box.max())}});
  problem.cost = make_metric_field_cost({.field = metric::Formula{{squared, "0", squared}, {}}}, 2);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

WaypointsInitializer over(double x, double y) {
  Points way(2, 1);
  way.col(0) << x, y;
  return WaypointsInitializer(std::move(way));
}

FindOptions with_bracket(double tolerance) {
  FindOptions options;
  options.points = 40;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = tolerance})};
  return options;
}

}  // namespace

TEST_CASE("bracket: find_path says that no path in the box is cheaper") {
  const Problem problem = in_box(box(-1.2, 0.3, 2.8, 4.3), "1 / y^2", {0, 1}, {2, 3});
  const Result result = find_path(problem, StraightInitializer(), Newton(), with_bracket(1e-4));
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.scope == Scope::global);
  REQUIRE(result.certificate.global);
  const GlobalBound& bound = *result.certificate.global;
  CHECK(bound.outcome == ProofOutcome::proved);
  CHECK(bound.category == BoundCategory::proved);
  CHECK(bound.gap <= 1e-4);
  CHECK(bound.lower_bound <= 1.49099630899480838);
  REQUIRE(bound.grid);
  CHECK(bound.grid->upper >= 1.49099630899480838);
  CHECK(bound.grid->box.max() == Vector2d(2.8, 4.3));
  // A tolerance that is out of reach: what is proved is quoted, and the certificate stays a local one.
  const Result fine = find_path(problem, StraightInitializer(), Newton(),
                                {.post_processors = {std::make_shared<BracketPostProcessor>(
                                     GlobalBudget{.tolerance = 1e-11, .max_windows = 10000})}});
  CHECK(fine.status == Status::certified);
  CHECK(fine.certificate.scope == Scope::local);
  CHECK(fine.certificate.global.value().outcome == ProofOutcome::bounded);
}

/// Hills beside the line between the ends: from either side the cheaper way is delivered, where they differ by more
/// than the gap. LEASTCOST_BRACKET_PROBLEMS sets another number of them.
TEST_CASE("bracket: from either side of a hill the cheaper way is delivered") {
  Random random;
  for (int k = 0, count = planted_problems(40) / 20 + 1; k < count; ++k) {
    const double off = random.uniform(-0.4, 0.4), height = random.uniform(1.5, 4), width = random.uniform(0.5, 1.2);
    const std::string hill = "(1 + " + std::to_string(height) + " * exp(-(x^2 + (y - (" + std::to_string(off) +
                             "))^2) / " + std::to_string(width) + "))^2";
    CAPTURE(hill);
    const Problem problem = in_box(box(-3, -3, 3, 3), hill, {-2, 0}, {2, 0});
    FindOptions local;
    local.points = 40;
    double least = kInfinite;
    std::vector<double> delivered, gaps;
    for (const double side : {-1.0, 1.0}) {
      const Result alone = find_path(problem, over(0, 1.5 * side), Newton(), local);
      if (alone.certificate.certified()) least = std::min(least, alone.certificate.estimate.value);
      const Result all = find_path(problem, over(0, 1.5 * side), Newton(), with_bracket(1e-3));
      delivered.push_back(all.certificate.estimate.value);
      gaps.push_back(all.certificate.global.value().gap);
      CHECK(all.certificate.global->lower_bound <= least);
    }
    for (std::size_t i = 0; i < 2; ++i) CHECK(delivered[i] <= least * (1 + gaps[i]) + 1e-6);
  }
}

/// Two tangents and an arc, on either side of a disc: from either side the shorter way is delivered, where they differ
/// by more than the gap. LEASTCOST_BRACKET_PROBLEMS sets another number of them.
TEST_CASE("bracket: from either side of a disc the shorter way is delivered") {
  Random random;
  int told_apart = 0;
  const int count = planted_problems(40) / 20 + 1;
  for (int k = 0; k < count; ++k) {
    const Vector2d centre(random.uniform(-0.4, 0.4), random.uniform(-0.3, 0.3)), source(-1.5, 0), target(1.5, 0);
    const double radius = random.uniform(0.4, 0.8);
    CAPTURE(centre.transpose(), radius);
    const double to_s = (source - centre).norm(), to_t = (target - centre).norm();
    const auto length = [&](double side) {
      const Vector2d a = source - centre, b = target - centre;
      const double counter_clockwise = std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
      const double turn = std::fmod(-side * counter_clockwise + 4 * std::acos(-1.0), 2 * std::acos(-1.0));
      return std::sqrt(to_s * to_s - radius * radius) + std::sqrt(to_t * to_t - radius * radius) +
             radius * (turn - std::acos(radius / to_s) - std::acos(radius / to_t));
    };
    const double least = std::min(length(1), length(-1)), other = std::max(length(1), length(-1));
    Problem problem = in_box(box(-2, -2, 2, 2), "1", source, target);
    problem.manifold = std::make_shared<FreeSpace>(
        problem.manifold, FreeSpace::Obstacles{make_ball({.center = centre, .radius = radius})}, 0);
    for (const double side : {-1.0, 1.0}) {
      const Result result = find_path(problem, over(centre[0], centre[1] + 1.3 * side), Newton(), with_bracket(1e-2));
      const GlobalBound& bound = result.certificate.global.value();
      REQUIRE(bound.lower_bound <= least * (1 + kOfTruth));
      if (!(other > least / (1 - bound.gap))) continue;
      ++told_apart;
      CHECK(result.curve.cost == Approx(least).epsilon(1e-3));
    }
  }
  CHECK(told_apart > count / 2);
  if (count > 6) WARN(told_apart << " of " << 2 * count << " told apart by the gap");
}

TEST_CASE("bracket: around a disc, and from the wrong side of it") {
  Problem problem = in_box(box(-2, -2, 2, 2), "1", {-1.5, 0}, {1.5, 0});
  problem.manifold = std::make_shared<FreeSpace>(
      problem.manifold, FreeSpace::Obstacles{make_ball({.center = Vector2d(0, 0.2), .radius = 0.6})}, 0);
  // Two tangents and an arc, below the centre.
  const double far = std::hypot(1.5, 0.2), turn = std::acos(-1.0) - 2 * std::atan(0.2 / 1.5) - 2 * std::acos(0.6 / far);
  const double least = 2 * std::sqrt(far * far - 0.36) + 0.6 * turn;
  const Result result = find_path(problem, over(0, 1.2), Newton(), with_bracket(1e-2));
  REQUIRE(result.certificate.global);
  const GlobalBound& bound = *result.certificate.global;
  CHECK(bound.lower_bound <= least);
  CHECK(bound.lower_bound >= 0.99 * least);
  CHECK(bound.outcome == ProofOutcome::improved);
  CHECK(result.curve.x.row(1).minCoeff() < -0.3);
  CHECK(bound.grid.value().upper >= least);
  CHECK(bound.grid->upper <= 1.01 * least);
}

/// Beside a box of little clearance a place in its core is no deeper than it is: a cell that the rim cuts is searched.
/// The nodes of a grid of 512 cells lie just within these boxes, so that half a cell beside them is free.
TEST_CASE("bracket: around a box with sharp corners", "[.slow]") {
  constexpr double kClearance = 1e-6, kCell = 4.0 / 512, kWithin = 1e-6, kApart = 0.15;
  for (const int cells : {10, 14}) {
    CAPTURE(cells);
    const double half = (cells + 0.5) * kCell + kWithin;
    Problem problem = in_box(box(-2, -2, 2, 2), "1", {-kApart - half, 0}, {kApart + half, 0});
    const Vector2d corner = Vector2d::Constant(half);
    problem.manifold = std::make_shared<FreeSpace>(
        problem.manifold, FreeSpace::Obstacles{make_box_obstacle({.lower = -corner, .upper = corner})}, kClearance);
    // Two tangents of the arcs around two corners, the arcs, and the side.
    const double far = std::hypot(kApart, half);
    const double least = 2 * (std::sqrt(far * far - kClearance * kClearance) +
                              kClearance * (std::atan(half / kApart) + std::asin(kClearance / far)) + half);
    const Result result = find_path(problem, over(0, 1.5 * half), Newton(), with_bracket(1e-2));
    REQUIRE(result.certificate.global);
    CHECK(result.certificate.global->lower_bound <= least * (1 + kOfTruth));
    CHECK(result.certificate.global->lower_bound >= 0.96 * least);
  }
}

TEST_CASE("bracket: a way through a wall thinner than a cell is not gone on from, and what is proved is kept") {
  Problem problem = in_box(box(-2, -2, 2, 2), "1", {-1, -0.5}, {1, -0.5});
  problem.manifold = std::make_shared<FreeSpace>(
      problem.manifold, FreeSpace::Obstacles{make_box_obstacle({Vector2d(-0.001, -2.5), Vector2d(0.001, 1.5)})}, 0.004);
  const double around_top = 2 * std::hypot(1, 2);
  FindOptions options;
  options.post_processors = {
      std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 1e-2, .max_windows = 200000})};
  const Result result = find_path(problem, over(0, 1.8), Newton(), options);
  // What was searched comes too near to the wall, so that the first path is delivered.
  CHECK(result.curve.cost >= around_top);
  CHECK(result.curve.cost < 1.12 * around_top);
  const GlobalBound& bound = result.certificate.global.value();
  CHECK(bound.outcome == ProofOutcome::bounded);
  CHECK(bound.lower_bound <= result.curve.cost);
  CHECK(bound.lower_bound > 1.95);  // that of the straight line
}

TEST_CASE("bracket: blocked, with a reason") {
  const auto reason = [](const Problem& problem) {
    const Result result = find_path(problem, StraightInitializer(), Newton(), with_bracket(1e-3));
    CHECK(result.certificate.scope == Scope::local);
    const GlobalBound bound = result.curve.global.value();
    CHECK(bound.outcome == ProofOutcome::blocked);
    CHECK_FALSE(bound.proved);
    return bound.reason;
  };
  Problem problem = in_box(box(-2, -2, 2, 2), "1 + x^2", {-1, 0}, {1, 0.5});
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{2, {}});
  CHECK_THAT(reason(problem), Catch::Contains("finite bounds"));
}

TEST_CASE("bracket: sampled where nothing is known of the cost's derivatives at an end") {
  Problem singular = in_box(box(-2, -2, 2, 2), "1", {-1, 0}, {1, 0.5});
  singular.cost = make_metric_field_cost({.field = metric::Formula{{"1 + abs(x + 1)^0.5", "0.1 * x", "1"}, {}}}, 2);
  const Result result = find_path(singular, StraightInitializer(), Newton(), with_bracket(1e-2));
  const GlobalBound& bound = result.certificate.global.value();
  CHECK(bound.category == BoundCategory::sampled);
  CHECK(bound.outcome == ProofOutcome::sampled);
  CHECK(bound.lower_bound <= result.certificate.estimate.value);
}

}  // namespace leastcost::test
