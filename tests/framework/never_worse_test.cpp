// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What a search delivers is never dearer and never less clear than its first path, and has its own cost.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <leastcost/framework/family/find_family.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "framework/result/never_worse.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

/// A solver that fails, and leaves the points where they cost more: moved by `shift` times a bump along the path.
class Spoiling final : public Solver {
 public:
  explicit Spoiling(double shift) : shift_(shift) {}
  std::string_view name() const override { return "spoiling"; }

 private:
  SolveReport do_solve(PathEnergy&, CoordinatePath& path, const Monitor&) const override {
    const Index last = path.u.cols() - 1;
    for (Index i = 1; i < last; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(last);
      path.u(path.u.rows() - 1, i) += 4 * shift_ * t * (1 - t);
    }
    SolveReport report;
    report.termination = Termination::non_finite;
    report.history.resize(1);
    return report;
  }
  double shift_;
};

/// Returns long after the deadline.
class Late final : public Solver {
 public:
  explicit Late(double shift) : spoiling_(shift) {}
  std::string_view name() const override { return "late"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override {
    SolveReport report = spoiling_.solve(energy, path, monitor);
    std::this_thread::sleep_until(*monitor.deadline + std::chrono::milliseconds(50));
    report.termination = Termination::time_limit;
    return report;
  }
  Spoiling spoiling_;
};

Problem around_disc() {
  auto domain = std::make_shared<const FreeSpace>(
      space(2), std::vector<std::shared_ptr<const Obstacle>>{make_ball({Vector2d(0, 0), 1})}, 0);
  return {std::move(domain), make_euclidean_cost(2), make_kernel<Expm1Square>(), {Vector2d(-2, 0)}, {Vector2d(2, 0)}};
}

/// A detour above the disc, of length 2 sqrt(4 + 6.25).
WaypointsInitializer above(double y = 2.5) { return WaypointsInitializer(Vector2d(0, y)); }

bool says_first(const Result& result) {
  return std::any_of(result.notes.begin(), result.notes.end(), [](const std::string& note) {
    return note.find("the first path is delivered") != std::string::npos;
  });
}

}  // namespace

TEST_CASE("never worse: a search that was stopped before it had a curve is compared by its points", "[framework]") {
  const Problem problem = around_disc();
  Result stopped = find(problem, 20, above(), Spoiling(-2.5));  // through the disc, if it is not replaced
  stopped.status = Status::interrupted;
  stopped.path = stopped.initial;
  stopped.path.u.row(1).setZero();
  stopped.curve = {};
  const Result better = never_worse(problem, stopped, {}, {});
  CHECK(says_first(better));
  CHECK(better.path.u == stopped.initial.u);
  CHECK(better.curve.cost == Approx(stopped.initial_cost));
}

TEST_CASE("never worse: a failed search delivers its first path where that is cheaper", "[framework]") {
  const Problem problem = between(space(2), make_euclidean_cost(2), Vector2d(0, 0), Vector2d(1, 0));
  const Result result = find(problem, 20, StraightInitializer(), Spoiling(0.7));
  REQUIRE(result.status == Status::uncertified);
  CHECK(says_first(result));
  CHECK(result.curve.cost == Approx(1).margin(1e-12));
  CHECK(result.costs.sum() == Approx(1).margin(1e-12));
  CHECK(result.path.u.row(1).cwiseAbs().maxCoeff() == 0);
  CHECK_FALSE(result.certificate.failures.empty());
}

TEST_CASE("never worse: a solver that returns long after the deadline leaves the first path", "[framework]") {
  const Problem problem = around_disc();
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(500);
  const Result result = find_path(problem, above(), Late(GENERATE(5.0, -2.5)), {.points = 20}, monitor);
  REQUIRE(result.status == Status::interrupted);
  CHECK(says_first(result));
  CHECK(measure_clearance(*problem.manifold, result.path.u, false, {})->lower >= 0);
  CHECK(result.curve.cost <= 2 * std::sqrt(10.25) * (1 + 1e-9));
}

TEST_CASE("never worse: a first path through an obstacle is not preferred for want of time", "[framework]") {
  const Problem problem = around_disc();
  Monitor monitor;
  monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(500);
  const Result result = find_path(problem, above(1.05), Late(2.5), {.points = 20}, monitor);
  REQUIRE(result.status == Status::interrupted);
  REQUIRE(depth_in_obstacles(problem, result.first.path, 1e-9, {}) > 0);
  CHECK_FALSE(says_first(result));
}

TEST_CASE("never worse: a cheaper path within an obstacle gives way to a dearer clear one", "[framework]") {
  const Problem problem = around_disc();
  const int points = GENERATE(5, 20);
  const Result result = find(problem, points, above(), Spoiling(-2.5));
  CAPTURE(points, result.curve.cost);
  REQUIRE(result.status == Status::uncertified);
  CHECK(says_first(result));
  const auto clearance = measure_clearance(*problem.manifold, result.path.u, false, {});
  REQUIRE(clearance);
  CHECK(clearance->lower >= 0);
  CHECK(result.curve.cost <= 2 * std::sqrt(10.25) * (1 + 1e-9));
  CHECK(result.costs.sum() == Approx(result.curve.cost));
}

TEST_CASE("never worse: a family ranks and delivers what its members deliver", "[framework]") {
  const Problem problem = around_disc();
  std::vector<FamilyStart> starts = {{"high", problem, std::make_shared<WaypointsInitializer>(above(3))},
                                     {"low", problem, std::make_shared<WaypointsInitializer>(above(-2.5))}};
  FindOptions options{.points = 20};
  options.certificate.refine = 0;
  const Family family = find_family(starts, Spoiling(-2.5), options);
  REQUIRE_FALSE(family.members.empty());
  const FamilyMember& first = family.members.front();
  CHECK(first.rank_cost == Approx(first.result.curve.cost));
  CHECK(measure_clearance(*problem.manifold, first.result.path.u, false, {})->lower >= 0);
}

TEST_CASE("never worse: what a search improves stays, certified or not", "[framework]") {
  const Problem problem = around_disc();
  const Result result = find(problem, 20, above(), Newton());
  CHECK_FALSE(says_first(result));
  CHECK(result.curve.cost < 2 * std::sqrt(10.25));
}

TEST_CASE("never worse: few points around a disc, certified but dearer than the first path, are doubled",
          "[framework]") {
  // Tangents to a slightly larger disc and its arc: 1e-3 longer than the shortest path, of which few points see less.
  constexpr int kArc = 200;
  constexpr double kRadius = 1.001;
  const double begin = std::numbers::pi - std::acos(kRadius / 2), end = std::acos(kRadius / 2);
  Points around(2, kArc + 1);
  for (int i = 0; i <= kArc; ++i) {
    const double angle = begin + (end - begin) * i / kArc;
    around.col(i) = kRadius * Vector2d(std::cos(angle), std::sin(angle));
  }
  const WaypointsInitializer first(around);
  const Problem problem = around_disc();
  FindOptions options{.points = 12};
  options.certificate.refine = 0;
  const Result few = find_path(problem, first, Newton(), options);
  const double first_cost = PathEnergy(problem, 1).cost(few.first.path);
  REQUIRE(few.status == Status::uncertified);
  CHECK(few.certificate.failures.front().name() == "dearer_than_first");
  CHECK_THAT(few.certificate.failures.front().message, Catch::Contains("use more points"));
  CHECK(says_first(few));
  CHECK(few.curve.cost == Approx(first_cost));

  options.certificate.refine = 6;
  const Result doubled = find_path(problem, first, Newton(), options);
  CHECK(doubled.status == Status::certified);
  CHECK(doubled.curve.cost < first_cost);
  CHECK_FALSE(says_first(doubled));
  const double shortest = 2 * std::sqrt(3.0) + std::numbers::pi - 2 * std::acos(0.5);
  CHECK(doubled.curve.cost > shortest);
}

TEST_CASE("clearance: a path in contact far from the origin is clear to the last digits of its coordinates",
          "[framework]") {
  FindOptions options{.points = 40};
  options.post_processors = {std::make_shared<const TautPostProcessor>()};
  std::vector<double> costs;
  for (const Vector2d& origin : {Vector2d(0, 0), Vector2d(5e5, 5e6), Vector2d(-4.1e6, 2.3e6)}) {
    auto domain = std::make_shared<const FreeSpace>(
        space(2), std::vector<std::shared_ptr<const Obstacle>>{make_ball({origin + Vector2d(0.25, 0.01), 0.05})}, 0);
    const Problem problem{
        std::move(domain), make_euclidean_cost(2), make_kernel<Expm1Square>(), {origin}, {origin + Vector2d(0.5, 0)}};
    const Result result =
        find_path(problem, WaypointsInitializer(Points(origin + Vector2d(0.25, -0.06))), NoSolver(), options);
    CAPTURE(origin.transpose(), failures(result.certificate), result.notes);
    CHECK(result.status == Status::certified);
    CHECK_FALSE(says_first(result));
    costs.push_back(result.curve.cost);
  }
  for (const double cost : costs) CHECK(cost == Approx(costs.front()).epsilon(1e-6));
}

}  // namespace leastcost::test
