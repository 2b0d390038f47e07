// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Replanning an arm without a pause while a box moves to and fro and another one appears and disappears: memory, how
// late it comes back from its budget, and paths that an independent check finds in collision.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/replan/replanner.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/solvers/newton.hpp>
#include "benchmarks/arm_scene.hpp"
#include "tests/support/overrun.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;
using Clock = Monitor::Clock;

constexpr int kPoints = 50, kPlaces = 10;
constexpr int kStepsOfScene = 200, kStepsOfSway = 40, kStepsThere = 25;
constexpr double kSway = 0.1;        ///< m: how far a box goes to each side, at 1.6 cm a step at most
constexpr double kNothing = 1e-7;    ///< m
constexpr double kLate = 1e-3;       ///< s
constexpr double kTolerance = 1e-8;  ///< of the cost, relative
constexpr unsigned kFirstSeed = 400001;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

double resident_kilobytes() {
  std::ifstream file("/proc/self/statm");
  double all = 0, resident = 0;
  file >> all >> resident;
  return resident * 4;
}

double kilobytes_in_use() { return static_cast<double>(mallinfo2().uordblks) / 1024; }

double least_gap(const Arm& arm, const std::vector<Thing>& things, const Points& x) {
  double least = 1e9;
  for (Index i = 0; i + 1 < x.cols(); ++i)
    for (int place = 0; place <= kPlaces; ++place)
      least = std::min(least, own_gap(arm, things, Vector(x.col(i) + (x.col(i + 1) - x.col(i)) * place / kPlaces)));
  return least;
}

/// The last ball sways, the last box comes and goes.
std::vector<Thing> things_at(const Query& query, int step) {
  std::vector<Thing> things = query.things;
  things[kBalls].center.z() += kSway * std::sin(2 * kPi * step / kStepsOfSway);
  if ((step / kStepsThere) % 2 == 1) things.pop_back();
  return things;
}

struct Memory {
  double in_use = 0, resident = 0;
};

}  // namespace

/// Arguments: seconds (60), the budget in milliseconds (50).
int main(int count, char** arguments) {
  const double lasting = count > 1 ? std::atof(arguments[1]) : 60,
               budget = 1e-3 * (count > 2 ? std::atof(arguments[2]) : 50);
  const Arm arm = arms().front();
  Replanner planner(std::make_shared<Newton>(NewtonOptions{.tolerance = kTolerance}),
                    std::make_shared<RrtInitializer>(), {.points = kPoints, .certificate = {.enabled = false}});
  std::vector<double> late;
  late.reserve(10'000'000);  // the record itself must not grow
  std::map<std::string, int> why_none;
  int fresh = 0, kept = 0, no_ends = 0, none = 0, invalid = 0, late_by_clock = 0, step = 0;
  double deepest = 0, worst_wall = 0;
  const auto cost = make_euclidean_cost(static_cast<int>(arm.robot->kinematics->dimension()));
  Memory early, middle, end;
  Query query;
  const Clock::time_point begin = Clock::now();
  for (unsigned seed = kFirstSeed; seconds_since(begin) < lasting; ++step) {
    if (step % kStepsOfScene == 0) {
      do query = query_of(arm, seed += 2, 0);
      while (query.source.size() == 0 || query.target.size() == 0);
      planner.forget();
    }
    {
      const std::vector<Thing> things = things_at(query, step);
      Problem now = problem_of(arm, query, &things);
      now.cost = cost;
      Monitor monitor;
      monitor.deadline =
          Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(budget));
      Replan plan;
      late.push_back(test::overrun(*monitor.deadline, [&] { plan = planner.replan(now, monitor); }));
      const double wall = seconds_since(*monitor.deadline);
      worst_wall = std::max(worst_wall, wall);
      late_by_clock += wall > kLate ? 1 : 0;
      fresh += plan.outcome == ReplanOutcome::new_path ? 1 : 0;
      kept += plan.outcome == ReplanOutcome::old_path ? 1 : 0;
      if (plan.outcome == ReplanOutcome::no_valid_path) {
        const bool in_obstacle = std::min(own_gap(arm, things, query.source), own_gap(arm, things, query.target)) < 0;
        ++(in_obstacle ? no_ends : none);
        if (!in_obstacle) ++why_none[plan.why_not_new.substr(0, 60)];
      } else {
        const double gap = least_gap(arm, things, plan.result.curve.x);
        const bool ends_meet =
            plan.result.curve.x.col(0) == query.source && plan.result.curve.x.rightCols(1) == query.target;
        invalid += gap < -kNothing || !ends_meet ? 1 : 0;
        deepest = std::min(deepest, gap);
      }
    }
    const double passed = seconds_since(begin) / lasting;
    Memory& at = passed < 0.1 ? early : passed < 0.55 ? middle : end;
    at.in_use = std::max(at.in_use, kilobytes_in_use());
    at.resident = std::max(at.resident, resident_kilobytes());
  }
  std::sort(late.begin(), late.end());
  const auto late_count = late.end() - std::upper_bound(late.begin(), late.end(), kLate);
  std::printf(
      "%d plans in %.0f s, budget %.0f ms: new %d, kept %d, none %d, an end in an obstacle %d; invalid %d (least gap "
      "%.1e m)\n",
      step, lasting, 1e3 * budget, fresh, kept, none, no_ends, invalid, deepest);
  std::printf("late by more than 1 ms of thread time %td, worst %.3f ms; by the clock %d, worst %.3f ms\n", late_count,
              1e3 * late.back(), late_by_clock, 1e3 * worst_wall);
  std::printf(
      "memory in use, most, in the first tenth, until 0.55, later: %.0f, %.0f, %.0f KB; resident: %.0f, %.0f, %.0f "
      "KB\n",
      early.in_use, middle.in_use, end.in_use, early.resident, middle.resident, end.resident);
  for (const auto& [why, times] : why_none) std::printf("none, %d times: %s\n", times, why.c_str());
}
