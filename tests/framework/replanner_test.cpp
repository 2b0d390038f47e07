// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/replan/replanner.hpp>

#include <chrono>
#include <thread>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/replan/open_rest.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/solvers/newton.hpp>
#include "framework/replan/shortened.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/moving_discs.hpp"
#include "tests/support/overrun.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost {
namespace {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Eigen::Vector2d;

constexpr double kKept = 0.02;     ///< clearance that the worlds ask for
constexpr double kNothing = 1e-7;  ///< what a path may miss of it: 1e-9 of its size, and rounding

Replanner replanner_of(int points,
                       std::shared_ptr<const Initializer> initializer = std::make_shared<RrtInitializer>()) {
  return {std::make_shared<Newton>(), std::move(initializer),
          FindOptions{.points = points, .certificate = {.enabled = false}}};
}

Monitor in_milliseconds(double budget) {
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() + std::chrono::duration_cast<Monitor::Clock::duration>(
                                                 std::chrono::duration<double, std::milli>(budget));
  return monitor;
}

Points through(const Vector2d& place) {
  Points points(2, 1);
  points << place;
  return points;
}

}  // namespace

TEST_CASE("replanner: what is returned is valid now, while a disc moves over the path") {
  Replanner planner = replanner_of(60);
  int refused = 0, searched = 0;
  for (int step = 0; step < 60; ++step) {
    const test::Discs discs = test::eleven_discs(7 * step);
    const Replan plan = planner.replan(test::across(test::world_of(discs, kKept)));
    CAPTURE(step, plan.why_not_old, plan.why_not_new);
    refused += plan.outcome == ReplanOutcome::no_valid_path ? 1 : 0;
    searched += plan.from_initializer ? 1 : 0;
    if (plan.outcome == ReplanOutcome::no_valid_path) continue;
    CHECK(test::clearance_of(plan.result.curve.x, discs) >= kKept - kNothing);
    CHECK(plan.clearance.value().lower >= -kNothing);
    CHECK(plan.result.path.u.col(0) == Vector2d(0.5, 5));
  }
  CHECK(refused == 0);
  CHECK(searched < 10);  // the first one, and where a disc has closed the way
}

TEST_CASE("replanner: the old path stays where nothing cheaper is found") {
  const test::Discs none{{5, 20, 1}};
  Replanner planner = replanner_of(20, std::make_shared<StraightInitializer>());
  const Problem problem = test::across(test::world_of(none, kKept));
  CHECK(planner.replan(problem).outcome == ReplanOutcome::new_path);
  const Replan again = planner.replan(problem);
  CHECK(again.why_not_old.empty());
  CHECK_THAT(again.result.curve.cost, WithinAbs(9, 1e-12));
  CHECK_FALSE(again.from_initializer);
}

TEST_CASE("replanner: a solved path is kept without a solve until what holds it moves") {
  const test::Discs begin{{5, 5.2, 1}, {5, 8, 0.5}};
  Replanner planner({std::make_shared<Newton>(NewtonOptions{.tolerance = 1e-8}), std::make_shared<RrtInitializer>(),
                     FindOptions{.points = 60, .certificate = {.enabled = false}}});
  Problem problem = test::across(test::world_of(begin, kKept));
  const auto now = [&](double holding, double far) {
    test::Discs discs = begin;
    discs[0].y += holding;
    discs[1].y += far;
    problem.manifold = test::world_of(discs, kKept);
    return planner.replan(problem);
  };
  now(0, 0);
  const Replan solved = now(0, 0);
  REQUIRE(solved.outcome != ReplanOutcome::no_valid_path);
  const Replan kept = now(0, -0.3);
  CHECK(kept.outcome == ReplanOutcome::old_path);
  CHECK_THAT(kept.why_not_new, Contains("nothing that holds the old path has moved"));
  CHECK(kept.result.path.u == solved.result.path.u);
  const Replan freed = now(0.05, -0.3);
  CHECK(freed.outcome == ReplanOutcome::new_path);
  CHECK(freed.result.curve.cost < kept.result.curve.cost - 1e-4);
  const Replan pushed = now(-0.05, -0.3);
  CHECK(pushed.outcome == ReplanOutcome::new_path);
  CHECK(pushed.result.curve.cost > kept.result.curve.cost + 1e-4);
  CHECK(pushed.clearance.value().lower >= -kNothing);
}

TEST_CASE("replanner: what is beside a solved path but holds no point of it may move") {
  Replanner planner({std::make_shared<Newton>(NewtonOptions{.tolerance = 1e-8}),
                     std::make_shared<WaypointsInitializer>(through({5, 4.16})),
                     FindOptions{.points = 60, .certificate = {.enabled = false}}});
  Problem problem = test::across(test::world_of({{5, 5.2, 1}, {5, 3.8, 0.3}}, kKept));
  planner.replan(problem);
  const Replan solved = planner.replan(problem);
  REQUIRE(solved.outcome != ReplanOutcome::no_valid_path);
  REQUIRE(test::clearance_of(solved.result.curve.x, {{5, 3.8, 0.3}}) < kKept + 0.6 * 9 / 61);  // as far as a look goes
  problem.manifold = test::world_of({{5, 5.2, 1}, {5.02, 3.79, 0.3}}, kKept);
  const Replan kept = planner.replan(problem);
  CHECK(kept.outcome == ReplanOutcome::old_path);
  CHECK_THAT(kept.why_not_new, Contains("nothing that holds the old path has moved"));
  problem.manifold = test::world_of({{5, 5.22, 1}, {5.02, 3.79, 0.3}}, kKept);
  const Replan freed = planner.replan(problem);
  CHECK(freed.outcome == ReplanOutcome::new_path);
  CHECK(freed.result.curve.cost < kept.result.curve.cost);
}

TEST_CASE("replanner: what the last solve kept from obstacles is where the next one begins") {
  Replanner planner({std::make_shared<Newton>(NewtonOptions{.tolerance = 1e-8}), std::make_shared<RrtInitializer>(),
                     FindOptions{.points = 60, .certificate = {.enabled = false}}});
  Problem problem = test::across(test::world_of({{5, 5.2, 1}, {5, 8, 0.5}}, kKept));
  planner.replan(problem);
  planner.replan(problem);
  for (int step = 1; step <= 8; ++step) {
    const test::Discs discs{{5 + 0.01 * step, 5.2 - 0.01 * step, 1}, {5, 8, 0.5}};
    problem.manifold = test::world_of(discs, kKept);
    const Replan warm = planner.replan(problem);
    CAPTURE(step, warm.why_not_old, warm.why_not_new);
    REQUIRE(warm.outcome == ReplanOutcome::new_path);
    CHECK_FALSE(warm.from_initializer);
    CHECK(warm.result.solve.iterations <= 5);
    CHECK(test::clearance_of(warm.result.curve.x, discs) >= kKept - kNothing);
    const Result closely = improve_path(problem, warm.result.path, Newton(), {.certificate = {.enabled = false}});
    CHECK(warm.result.curve.cost <= closely.curve.cost * (1 + 1e-4));
  }
  // Another number of obstacles: nothing is known of their margins.
  const test::Discs fewer{{5.1, 5.1, 1}};
  problem.manifold = test::world_of(fewer, kKept);
  const Replan other = planner.replan(problem);
  REQUIRE(other.outcome != ReplanOutcome::no_valid_path);
  CHECK(test::clearance_of(other.result.curve.x, fewer) >= kKept - kNothing);
}

TEST_CASE("replanner: a straight path rests without obstacles, and is known to as long as cost and box stay") {
  const test::Discs none{{5, 20, 1}};
  Problem problem = test::across(test::world_of(none, kKept));
  CoordinatePath path{Points(2, 12), {}, false};
  for (int row = 0; row < 2; ++row) path.u.row(row).setLinSpaced(12, problem.source.u[row], problem.target.u[row]);
  const double cost = (problem.target.u - problem.source.u).norm();
  OpenRest rest;
  CHECK(rest.holds(problem, path, cost, {}));
  problem.manifold = test::world_of({{5, 19, 1}}, kKept);
  CHECK(rest.holds(problem, path, cost, {}));
  CoordinatePath bent = path;
  bent.u(1, 5) += 0.1;
  CHECK_FALSE(rest.holds(problem, bent, cost, {}));
  CHECK(rest.holds(problem, path, cost, {}));
}

TEST_CASE("replanner: a change far from the path costs nothing, one that opens a shorter way nearby is used") {
  test::Discs discs{{5, 5.5, 1}};
  Replanner planner = replanner_of(60, std::make_shared<WaypointsInitializer>(through({5, 4})));
  const double before = planner.replan(test::across(test::world_of(discs, kKept))).result.curve.cost;
  discs[0].r = 0.7;
  const double after = planner.replan(test::across(test::world_of(discs, kKept))).result.curve.cost;
  CHECK(after < before - 0.01);
}

TEST_CASE("replanner: no valid path is an outcome, and a later world has one again") {
  Replanner planner = replanner_of(40);
  const test::Discs open{{5, 5, 1}};
  CHECK(planner.replan(test::across(test::world_of(open, kKept))).outcome != ReplanOutcome::no_valid_path);
  const test::Discs on_target{{9.5, 5.2, 0.5}};
  const Replan closed = planner.replan(test::across(test::world_of(on_target, kKept)));
  CHECK(closed.outcome == ReplanOutcome::no_valid_path);
  CHECK(closed.result.path.u.cols() == 0);
  CHECK_THAT(closed.why_not_new, Contains("the target lies"));
  CHECK(word_of(closed.outcome) == "no_valid_path");
  CHECK(planner.replan(test::across(test::world_of(open, kKept))).outcome != ReplanOutcome::no_valid_path);
}

TEST_CASE("replanner: a robot that drives along its path") {
  Replanner planner = replanner_of(60);
  Problem problem = test::across(nullptr);
  for (int step = 0; step < 60; ++step) {
    const test::Discs discs = test::eleven_discs(step);
    problem.manifold = test::world_of(discs, kKept);
    const Replan plan = planner.replan(problem);
    CAPTURE(step, plan.why_not_old, plan.why_not_new);
    REQUIRE(plan.outcome != ReplanOutcome::no_valid_path);
    CHECK(plan.result.path.u.col(0) == problem.source.u);
    CHECK(test::clearance_of(plan.result.curve.x, discs) >= kKept - kNothing);
    problem.source.u = plan.result.path.u.col(1);
    problem.manifold = test::world_of(test::eleven_discs(step + 1), kKept);
    if (!why_in_clearance(problem, problem.source).empty()) break;
  }
  CHECK(problem.source.u[0] > 3);
}

TEST_CASE("replanner: an end on a point of the path leaves no two points alike") {
  const auto cut = [](const Vector2d& source, const Vector2d& target) {
    Problem problem = test::across(test::world_of({}, kKept));
    problem.source.u = source;
    problem.target.u = target;
    CoordinatePath path;
    path.u.resize(2, 5);
    path.u << 0, 1, 2, 3, 4, 0, 0, 0, 0, 0;
    CHECK(shorten_to_ends(problem, path));
    return path.u;
  };
  CHECK(cut({1, 0}, {4, 0}).row(0) == Eigen::RowVector4d(1, 2, 3, 4));
  CHECK(cut({0, 0}, {3, 0}).row(0) == Eigen::RowVector4d(0, 1, 2, 3));
  CHECK(cut({1.5, 0}, {2.5, 0}).row(0) == Eigen::RowVector3d(1.5, 2, 2.5));
  CHECK(cut({4.5, 0}, {5, 0}).cols() == 2);
}

TEST_CASE("replanner: without obstacles, on a curved domain, the path is that of find_path") {
  Problem problem;
  problem.manifold = std::make_shared<test::Sphere>();
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector3d(1, 0, 0);
  Replanner planner = replanner_of(30, std::make_shared<StraightInitializer>());
  for (const double angle : {1.0, 1.1, 1.2}) {
    problem.target.u = Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
    const Replan plan = planner.replan(problem);
    CHECK(plan.outcome == ReplanOutcome::new_path);
    CHECK_FALSE(plan.clearance.has_value());
    CHECK_THAT(plan.result.curve.cost, WithinAbs(62 * std::sin(angle / 62), 1e-7));
  }
}

TEST_CASE("replanner: the budget holds, and a valid old path is returned however small it is") {
  constexpr double kGenerous = 0.1;  // s; this may be a sanitizer on a busy machine: benchmarks/replan_table measures
  for (const int points : {100, 1000}) {
    Replanner planner = replanner_of(points);
    test::Discs discs = test::many_discs(100, 0.1, 1);
    REQUIRE(planner.replan(test::across(test::world_of(discs, kKept))).outcome != ReplanOutcome::no_valid_path);
    int late = 0;
    for (int k = 0; k < 50; ++k) {
      discs[0].x += 1e-3;
      const Problem now = test::across(test::world_of(discs, kKept));
      const double budget = 2;
      const Monitor monitor = in_milliseconds(budget);
      Replan plan;
      const double over = test::overrun(*monitor.deadline, [&] { plan = planner.replan(now, monitor); });
      late += over > kGenerous ? 1 : 0;
      if (plan.outcome == ReplanOutcome::no_valid_path) continue;
      CHECK(test::clearance_of(plan.result.curve.x, discs) >= kKept - kNothing);
    }
    CHECK(late <= 1);
  }
}

TEST_CASE("replanner: planners of several threads share a world") {
  const test::Discs discs = test::many_discs(60, 0.3, 3);
  const Problem problem = test::across(test::world_of(discs, kKept));
  std::vector<double> costs(3);
  std::vector<std::thread> threads;
  for (double& cost : costs)
    threads.emplace_back([&] {
      Replanner planner = replanner_of(30);
      for (int k = 0; k < 3; ++k) cost = planner.replan(problem).result.curve.cost;
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(costs[0] > 9);
  CHECK(costs[1] == costs[0]);
  CHECK(costs[2] == costs[0]);
}

TEST_CASE("replanner: what does not fit is refused") {
  const auto newton = std::make_shared<Newton>();
  const auto straight = std::make_shared<StraightInitializer>();
  CHECK_THROWS_AS(Replanner(nullptr, straight, {}), InputError);
  CHECK_THROWS_AS(Replanner(newton, nullptr, {}), InputError);
  CHECK_THROWS_AS(Replanner(newton, straight, {.points = std::nullopt}), InputError);
  CHECK_THROWS_AS(replanner_of(10).replan(Problem{}), InputError);
}

}  // namespace leastcost
