// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Plans among 25 discs in the plane, pulled tight from a path on a grid: against the shortest of all (a tangent graph
// that shares no code with ours), and in times of the search on the grid.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include "benchmarks/disc_scene.hpp"
#include "benchmarks/thread_time.hpp"
#include "tests/adversarial/planning/judge/tangent_graph.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;

constexpr int kDiscs = 25, kPoints = 100;
constexpr double kSameClass = 2e-6;  ///< relative: an excess of the polyline, not of another class

}  // namespace

/// Arguments: how many scenes, the first seed; 1000 and 1 unless given.
int main(int count, char** arguments) {
  const int scenes = count > 1 ? std::atoi(arguments[1]) : 1000;
  const auto first = static_cast<unsigned>(count > 2 ? std::atoi(arguments[2]) : 1);
  FindOptions options;
  options.points = kPoints;
  options.post_processors = {std::make_shared<const TautPostProcessor>()};
  int found = 0, certified = 0, closed = 0;
  std::vector<double> shortest, excess, times;
  for (unsigned seed = first; seed < first + static_cast<unsigned>(scenes); ++seed) {
    const DiscScene scene = disc_scene(seed, kDiscs);
    const auto best = judge::shortest_among_discs(scene.judged);
    if (!best) {
      ++closed;
      continue;
    }
    try {
      const double begin = thread_seconds();
      GridInitializer().first_path(scene.problem, {});
      const double searched = thread_seconds();
      const Result result = find_path(scene.problem, GridInitializer(), NoSolver(), options);
      const double all = thread_seconds();
      ++found;
      certified += result.status == Status::certified ? 1 : 0;
      times.push_back((all - searched) / (searched - begin) - 1);
      const double too_long = result.curve.cost / *best - 1;
      (too_long < kSameClass ? shortest : excess).push_back(too_long);
    } catch (const std::exception& error) {
      std::printf("seed %u: %s\n", seed, error.what());
    }
  }
  std::printf("%d scenes: %d closed, %d found, %d certified\n", scenes, closed, found, certified);
  std::printf("in the class of the shortest: %zu, excess median %.1e, worst %.1e\n", shortest.size(),
              quantile_of(shortest, 0.5), quantile_of(shortest, 1));
  std::printf("in another class: %zu, longer than the shortest of all by: median %.1e, worst %.1e\n", excess.size(),
              quantile_of(excess, 0.5), quantile_of(excess, 1));
  std::printf("taut, spaced and certified, in times of the search on the grid: median %.2f, p99 %.2f, worst %.2f\n",
              quantile_of(times, 0.5), quantile_of(times, 0.99), quantile_of(times, 1));
}
