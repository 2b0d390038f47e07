// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/search/bracket.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
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
#include "tests/problems/planted_space.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double kEndless = std::numeric_limits<double>::infinity();

std::shared_ptr<const SegmentCost> isotropic_cost(const std::string& squared) {
  return make_metric_field_cost({.field = metric::Formula{{squared, "0", "0", squared, "0", squared}, {}}}, 3);
}

}  // namespace

/// Closed forms (docs/oracles.md), and gaps that the construction is built for.
TEST_CASE("bracket in space: media with known least costs", "[slow]") {
  struct Case {
    const char* density;
    Vector3d source, target;
    AlignedBox3d box;
    double cost, gap;
  };
  std::vector<Case> cases = {
      {"1",
       {-1, 0.3, 0.1},
       {1.2, -0.4, -0.3},
       {Vector3d(-1.6, -1.6, -1.6), Vector3d(1.6, 1.6, 1.6)},
       std::sqrt(5.49),
       1e-3},
      {"2 / (1 + x^2 + y^2 + z^2)",
       {0.5, -0.2, 0.1},
       {-0.7, 0.9, -0.2},
       {Vector3d(-1.4, -1, -1.4), Vector3d(1.4, 1.8, 1.4)},
       2 * std::asin(std::sqrt(2.74 / (1.3 * 2.34))),
       6e-3},
      {"1 / z",
       {0, 0.1, 1},
       {1.6, 1.3, 3},
       {Vector3d(-1, -1.2, 0.4), Vector3d(2.6, 2.4, 4)},
       std::acosh(1 + 8.0 / 6),
       8e-3},
      {"1 / (1 + 0.5 * z)",
       {0, 0, 0},
       {3.2, 2.4, 1},
       {Vector3d(-0.5, -0.5, -0.5), Vector3d(4.5, 4.5, 4.5)},
       3.05937323665641694,
       6e-3},
  };
  if (planted_problems(2) < 100) cases.resize(2);  // the others take some seconds each
  for (const Case& c : cases) {
    CAPTURE(c.density);
    const std::shared_ptr<const SpaceDensity> density = isotropic_density(c.density);
    const SpaceBracket found =
        bracket_least_cost(*density, c.box, c.source, c.target, kEndless, {.tolerance = c.gap, .cells = 24});
    CHECK(found.lower <= c.cost * (1 + 1e-12));
    CHECK(found.upper >= c.cost * (1 - 1e-12));
    CHECK(found.gap() <= c.gap);
    REQUIRE(found.way.cols() > 2);
    CHECK(found.way.leftCols(1) == c.source);
    CHECK(found.way.rightCols(1) == c.target);
  }
}

TEST_CASE("bracket in space: around a ball") {
  const std::shared_ptr<const SpaceDensity> density = isotropic_density("1");
  // Two tangents and an arc.
  const double least = 2 * std::sqrt(3.0) + std::acos(-1.0) / 3;
  SpaceBracketOptions options{.tolerance = 1e-6, .cells = 32, .max_cells = 64};
  options.depth = [](const Vector3d& x) { return 1 - x.norm(); };
  const SpaceBracket found = bracket_least_cost(*density, {Vector3d(-2.6, -1.8, -1.8), Vector3d(2.6, 1.8, 1.8)},
                                                Vector3d(-2, 0, 0), Vector3d(2, 0, 0), least * (1 + 1e-6), options);
  CHECK(found.lower <= least);
  CHECK(found.lower > 4.05);  // straight through it would be 4
}

TEST_CASE("bracket in space: nothing is proved of what is not known") {
  const AlignedBox3d around(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
  const Vector3d s(-0.5, 0, 0), t(0.5, 0.1, 0);
  const SpaceBracketOptions coarse{.cells = 24, .max_cells = 24};
  // Not the isotropic cost, but by formula: the bound is of the cheaper direction, and holds.
  const auto metric = [](const std::string& xy, const std::string& yy) {
    return space_density_of(make_metric_field_cost({.field = metric::Formula{{"1", xy, "0", yy, "0", "9"}, {}}}, 3));
  };
  const SpaceBracket weak = bracket_least_cost(*metric("0", "4"), around, s, t, 1.1, coarse);
  CHECK(weak.lower > 0.8);
  CHECK(weak.lower <= std::hypot(1, 0.1));
  CHECK(bracket_least_cost(*metric("0.1", "1"), around, s, t, 2, coarse).lower == 0);
  // A place in the box where the formula has no value: only the surroundings of an end prove something.
  CHECK(bracket_least_cost(*isotropic_density("sqrt(log(x + 0.8)^2 + 1)"), around, s, t, 10, coarse).lower < 0.5);
  CHECK_THROWS_AS(bracket_least_cost(*metric("0", "1"), around, s, Vector3d(2, 0, 0)), InputError);
  CHECK_THROWS_AS(bracket_least_cost(*metric("0", "1"), AlignedBox3d(), s, t), InputError);
}

TEST_CASE("bracket in space: stopped at any time it keeps what is proved") {
  const std::shared_ptr<const SpaceDensity> density = isotropic_density("2 / (1 + x^2 + y^2 + z^2)");
  const double least = 2 * std::asin(std::sqrt(2.74 / (1.3 * 2.34)));
  for (const int after : {0, 3, 30, 100}) {
    int looks = 0;
    SpaceBracketOptions options{.tolerance = 1e-9, .cells = 20, .max_cells = 80};
    options.stop = [&] { return ++looks > after; };
    const SpaceBracket found =
        bracket_least_cost(*density, {Vector3d(-1.4, -1, -1.4), Vector3d(1.4, 1.8, 1.4)}, Vector3d(0.5, -0.2, 0.1),
                           Vector3d(-0.7, 0.9, -0.2), kEndless, options);
    CHECK(found.stopped);
    CHECK(looks == after + 1);
    CHECK(found.lower <= least);
  }
}

namespace {

Problem in_space(const AlignedBox3d& box, const std::shared_ptr<const SegmentCost>& cost, const Vector3d& source,
                 const Vector3d& target) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(
      EuclideanManifoldOptions{3, {Eigen::VectorXd(box.min()), Eigen::VectorXd(box.max())}});
  problem.cost = cost;
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

FindOptions bracketed(double tolerance) {
  FindOptions options;
  options.points = 40;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = tolerance})};
  return options;
}

}  // namespace

TEST_CASE("bracket in space: find_path says that no path in the box is cheaper", "[slow]") {
  const AlignedBox3d box(Vector3d(-1, -1.2, 0.4), Vector3d(2.6, 2.4, 4));
  const Problem problem = in_space(box, isotropic_cost("1 / z^2"), {0, 0.1, 1}, {1.6, 1.3, 3});
  const Result result = find_path(problem, StraightInitializer(), Newton(), bracketed(5e-3));
  CHECK(result.status == Status::certified);
  CHECK(result.certificate.scope == Scope::global);
  REQUIRE(result.certificate.global);
  const GlobalBound& bound = *result.certificate.global;
  CHECK(bound.outcome == ProofOutcome::proved);
  CHECK(bound.category == BoundCategory::proved);
  CHECK(bound.gap <= 5e-3);
  const double least = std::acosh(1 + 8.0 / 6);
  CHECK(bound.lower_bound <= least);
  REQUIRE(bound.grid);
  CHECK(bound.grid->upper >= least);
  CHECK(bound.grid->cells.size() == 3);
  CHECK(bound.grid->box.max() == Vector3d(2.6, 2.4, 4));
  CHECK(bound.grid->potential.values.empty());
}

TEST_CASE("bracket in space: from the dearer side of a hill the cheaper way is delivered", "[slow_sanitized]") {
  const AlignedBox3d box(Vector3d(-2.3, -1.9, -1), Vector3d(2.3, 1.9, 1));
  const Problem problem =
      in_space(box, isotropic_cost("(1 + 2 * exp(-x^2 - (y + 0.4)^2 - z^2 / 9))^2"), {-2, 0, 0}, {2, 0, 0});
  Points below(3, 1);
  below.col(0) << 0, -1.6, 0;
  const Result result = find_path(problem, WaypointsInitializer(below), Newton(), bracketed(0.05));
  REQUIRE(result.certificate.global);
  CHECK(result.certificate.global->outcome == ProofOutcome::improved);
  CHECK(result.curve.x.row(1).maxCoeff() > 0.5);
}

/// Two corners of a bar across the box, on either side of it.
TEST_CASE("bracket in space: from the dearer side of a bar the shorter way is delivered", "[slow]") {
  constexpr double kClearance = 0.1;
  const AlignedBox3d box(Vector3d(-1.4, -1.4, -0.6), Vector3d(1.4, 1.4, 0.6));
  Problem problem = in_space(box, make_euclidean_cost(3), {-1, 0, 0}, {1, 0, 0});
  problem.manifold = std::make_shared<FreeSpace>(
      problem.manifold,
      FreeSpace::Obstacles{make_box_obstacle({.lower = Vector3d(-0.6, -0.3, -9), .upper = Vector3d(0.6, 0.5, 9)})},
      kClearance);
  Points above(3, 1);
  above.col(0) << 0, 1, 0;
  FindOptions coarse;
  coarse.post_processors = {
      std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 0.08, .max_windows = 150000})};
  const Result result = find_path(problem, WaypointsInitializer(above), Newton(), coarse);
  const double far = 0.5, turn = std::atan(0.3 / 0.4) + std::asin(kClearance / far);
  const double least = 2 * (std::sqrt(far * far - kClearance * kClearance) + kClearance * turn + 0.6);
  CHECK(result.curve.x.row(1).minCoeff() < -0.35);
  CHECK(result.curve.cost >= least);
  CHECK(result.curve.cost < 1.01 * least);
  CHECK(result.certificate.global.value().lower_bound <= least);
}

TEST_CASE("bracket in space: blocked, with a reason") {
  const AlignedBox3d box(Vector3d(-2, -2, -2), Vector3d(2, 2, 2));
  const auto reason = [](const Problem& problem) {
    const Result result = find_path(problem, StraightInitializer(), Newton(), bracketed(1e-2));
    CHECK(result.certificate.scope == Scope::local);
    const GlobalBound bound = result.curve.global.value();
    CHECK(bound.outcome == ProofOutcome::blocked);
    CHECK_FALSE(bound.proved);
    return bound.reason;
  };
  const auto stretched = make_metric_field_cost({.field = metric::Formula{{"1", "0", "0", "2", "0", "1"}, {}}}, 3);
  CHECK_THAT(reason(in_space(box, stretched, {-1, 0, 0}, {1, 0.5, 0})), Catch::Contains("isotropic cost"));
  Problem open = in_space(box, isotropic_cost("1 + x^2"), {-1, 0, 0}, {1, 0.5, 0});
  open.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{3, {}});
  CHECK_THAT(reason(open), Catch::Contains("finite bounds"));
}

}  // namespace leastcost::test
