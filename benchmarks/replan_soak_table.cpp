// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Replanning without a pause among discs that all move: memory after the first second and at the end, how late it comes
// back from its budget, and paths that an independent check finds penetrating.
#include <malloc.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/replan/replanner.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "benchmarks/thread_time.hpp"
#include "tests/support/moving_discs.hpp"
#include "tests/support/overrun.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;
using Clock = Monitor::Clock;

constexpr double kClearance = 0.02;
constexpr double kNothing = 1e-7;
constexpr double kMostOfBudget = 0.9;  ///< who got less of it from the machine was not given its time

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

double kilobytes_in_use() { return static_cast<double>(mallinfo2().uordblks) / 1024; }

}  // namespace

/// Arguments: seconds (60), the budget in milliseconds (10), `newton` or `taut`.
int main(int count, char** arguments) {
  const double lasting = count > 1 ? std::atof(arguments[1]) : 60,
               budget = 1e-3 * (count > 2 ? std::atof(arguments[2]) : 10);
  constexpr std::size_t kMostPlans = 10'000'000;
  std::vector<float> late;
  late.reserve(kMostPlans);  // the record itself must not grow
  const bool taut = count > 3 && std::string(arguments[3]) == "taut";
  FindOptions options{.points = 100, .certificate = {.enabled = false}};
  std::shared_ptr<const Solver> solver = std::make_shared<Newton>(NewtonOptions{.tolerance = 1e-8});
  if (taut) {
    solver = std::make_shared<NoSolver>();
    options.post_processors = {std::make_shared<const TautPostProcessor>(TautOptions{.excess = 1e-5})};
  }
  Replanner planner(solver, std::make_shared<RrtInitializer>(), options);
  double after_one_second = 0, most_after = 0, worst_wall = 0;
  int penetrating = 0, without = 0, starved = 0;
  const Clock::time_point begin = Clock::now();
  for (int step = 0; seconds_since(begin) < lasting && late.size() < kMostPlans; ++step) {
    {
      const test::Discs discs = test::all_moving(step);
      const Problem now = test::across(test::world_of(discs, kClearance));
      Monitor monitor;
      monitor.deadline =
          Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(budget));
      Replan plan;
      const double before = thread_seconds();
      late.push_back(
          static_cast<float>(test::overrun(*monitor.deadline, [&] { plan = planner.replan(now, monitor); })));
      worst_wall = std::max(worst_wall, seconds_since(*monitor.deadline));
      const bool had_its_time = thread_seconds() - before >= kMostOfBudget * budget;
      if (plan.outcome == ReplanOutcome::no_valid_path) {
        ++without;
        starved += had_its_time ? 0 : 1;
      } else {
        penetrating += test::clearance_of(plan.result.curve.x, discs) < kClearance - kNothing ? 1 : 0;
      }
    }
    const double kilobytes = kilobytes_in_use();
    if (seconds_since(begin) < 1)
      after_one_second = std::max(after_one_second, kilobytes);
    else
      most_after = std::max(most_after, kilobytes);
  }
  std::sort(late.begin(), late.end());
  const auto at = [&](double part) {
    return 1e3 *
           static_cast<double>(
               late[std::min(late.size() - 1, static_cast<std::size_t>(part * static_cast<double>(late.size())))]);
  };
  std::printf(
      "%zu plans in %.0f s, budget %.1f ms: late by p50 %.3f, p99 %.3f, p99.99 %.3f ms of thread time, worst %.3f; by "
      "the wall %.3f; memory in use after one second %.1f, most later %.1f KB; without a path %d, of which %d "
      "were given less than %.0f %% of their budget by the machine; penetrating %d\n",
      late.size(), lasting, 1e3 * budget, at(0.5), at(0.99), at(0.9999), at(1), 1e3 * worst_wall, after_one_second,
      most_after, without, starved, 100 * kMostOfBudget, penetrating);
}
