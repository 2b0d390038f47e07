// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Replanning among discs that move: processor time in Newton solves of the same chain without obstacles, what was
// refused and what an independent check finds penetrating; how late it comes back from a budget; what a new world
// costs.
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

#include <leastcost/framework/replan/replanner.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "tests/support/moving_discs.hpp"
#include "tests/support/overrun.hpp"

namespace {

using namespace leastcost;

constexpr double kClearance = 0.02;
constexpr double kNothing = 1e-7;
constexpr double kTolerance = 1e-8;  ///< of the cost, relative

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Of sorted values.
double quantile(const std::vector<double>& sorted, double part) {
  return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(part * static_cast<double>(sorted.size())))];
}

FindOptions options_of(int points) { return {.points = points, .certificate = {.enabled = false}}; }

Replanner planner_of(int points) {
  return {std::make_shared<Newton>(NewtonOptions{.tolerance = kTolerance}), std::make_shared<RrtInitializer>(),
          options_of(points)};
}

/// Without a solver: the old path is pulled tight anew.
Replanner taut_planner_of(int points) {
  FindOptions options = options_of(points);
  options.post_processors = {std::make_shared<const TautPostProcessor>(TautOptions{.excess = 1e-5})};
  return {std::make_shared<NoSolver>(), std::make_shared<RrtInitializer>(), options};
}

using MakePlanner = Replanner (*)(int points);

/// Seconds of a Newton solve of the chain that goes around the discs, from there, without them; the median of 101.
double newton_solve(const CoordinatePath& chain) {
  const Problem problem = test::across(std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2}));
  std::vector<double> seconds;
  for (int i = 0; i < 101; ++i) {
    const double begin = cpu_now();
    improve_path(problem, chain, Newton({.tolerance = kTolerance}), options_of(static_cast<int>(chain.free_count())));
    seconds.push_back(cpu_now() - begin);
  }
  std::sort(seconds.begin(), seconds.end());
  return quantile(seconds, 0.5);
}

void rates(const char* name, MakePlanner make, test::Discs (*world)(int), int steps) {
  Replanner planner = make(100);
  std::vector<double> seconds;
  int refused = 0, needlessly = 0, penetrating = 0, searched = 0, kept = 0;
  for (int step = 0; step < steps; ++step) {
    const test::Discs discs = world(step);
    const double begin = cpu_now();
    const Replan plan = planner.replan(test::across(test::world_of(discs, kClearance)));
    seconds.push_back(cpu_now() - begin);
    searched += plan.from_initializer ? 1 : 0;
    kept += plan.outcome == ReplanOutcome::old_path ? 1 : 0;
    if (plan.outcome != ReplanOutcome::no_valid_path) {
      penetrating += test::clearance_of(plan.result.curve.x, discs) < kClearance - kNothing ? 1 : 0;
      continue;
    }
    ++refused;
    const Replan offline = make(100).replan(test::across(test::world_of(discs, kClearance)));
    needlessly += offline.outcome != ReplanOutcome::no_valid_path ? 1 : 0;
  }
  const double mean = [&] {
    double sum = 0;
    for (const double s : seconds) sum += s;
    return sum / static_cast<double>(seconds.size());
  }();
  std::sort(seconds.begin(), seconds.end());
  const double unit = newton_solve(planner.path());
  std::printf(
      "%-18s %d steps: solve %.3f ms; mean %.1f, median %.1f, p99 %.1f, worst %.1f solves; refused %d, of them solved "
      "offline %d; penetrating %d; first paths %d; old path kept %d\n",
      name, steps, 1e3 * unit, mean / unit, quantile(seconds, 0.5) / unit, quantile(seconds, 0.99) / unit,
      seconds.back() / unit, refused, needlessly, penetrating, searched, kept);
  std::fflush(stdout);
}

void budgets(const char* name, MakePlanner make) {
  for (const int points : {100, 2000}) {
    Replanner planner = make(points);
    test::Discs discs = test::many_discs(300, 0.1, 1);
    planner.replan(test::across(test::world_of(discs, kClearance)));
    std::vector<double> over;
    int valid = 0, fresh = 0, penetrating = 0;
    constexpr int kRuns = 300;
    for (int k = 0; k < kRuns; ++k) {
      for (test::Disc& disc : discs) disc.y += 0.002 * ((k / 50) % 2 == 0 ? 1 : -1);
      const Problem now = test::across(test::world_of(discs, kClearance));
      Monitor monitor;
      monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(2);
      Replan plan;
      over.push_back(test::overrun(*monitor.deadline, [&] { plan = planner.replan(now, monitor); }));
      valid += plan.outcome != ReplanOutcome::no_valid_path ? 1 : 0;
      fresh += plan.outcome == ReplanOutcome::new_path ? 1 : 0;
      if (plan.outcome != ReplanOutcome::no_valid_path)
        penetrating += test::clearance_of(plan.result.curve.x, discs) < kClearance - kNothing ? 1 : 0;
    }
    std::sort(over.begin(), over.end());
    std::printf(
        "%-18s budget 2 ms, 300 discs, n = %d: late by p50 %.3f, p99 %.3f, worst %.3f ms of thread time; valid %d of "
        "%d, new %d, penetrating %d\n",
        name, points, 1e3 * quantile(over, 0.5), 1e3 * quantile(over, 0.99), 1e3 * over.back(), valid, kRuns, fresh,
        penetrating);
    std::fflush(stdout);
  }
}

void worlds() {
  for (const int count : {11, 300, 10000}) {
    const test::Discs discs = test::many_discs(count, 0.01, 1);
    FreeSpace::Obstacles obstacles;
    const auto plane = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
    std::vector<double> making, indexing;
    for (int i = 0; i < 21; ++i) {
      const double begin = cpu_now();
      obstacles.clear();
      for (const test::Disc& d : discs)
        obstacles.push_back(make_ball({.center = Eigen::Vector2d(d.x, d.y), .radius = d.r}));
      const double made = cpu_now();
      const FreeSpace world(plane, obstacles, kClearance);
      making.push_back(made - begin);
      indexing.push_back(cpu_now() - made);
    }
    std::sort(making.begin(), making.end());
    std::sort(indexing.begin(), indexing.end());
    std::printf("world of %d discs: obstacles %.3f ms, free space %.3f ms\n", count, 1e3 * quantile(making, 0.5),
                1e3 * quantile(indexing, 0.5));
  }
}

}  // namespace

/// Argument: how many steps without a solver, a hundredth of them with one; 20,000 unless given.
int main(int count, char** arguments) {
  const int steps = count > 1 ? std::atoi(arguments[1]) : 20000;
  worlds();
  const std::tuple<const char*, MakePlanner, int> planners[] = {{"newton", planner_of, steps / 100},
                                                                {"taut", taut_planner_of, steps}};
  for (const auto& [name, make, count_of_steps] : planners) {
    rates((name + std::string(", one moves")).c_str(), make, test::eleven_discs, count_of_steps);
    rates((name + std::string(", all move")).c_str(), make, test::all_moving, count_of_steps);
    budgets(name, make);
  }
}
