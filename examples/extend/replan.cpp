// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Replanning on a budget among discs that move. Each plan starts from the one before, and what comes back in time is
// the cheapest of the paths that are valid now.
#include <chrono>
#include <cmath>
#include <cstdio>

#include <leastcost/leastcost.hpp>

using namespace leastcost;

/// The plane without the discs, where they are at a time.
std::shared_ptr<const ConstraintManifold> world_at(double time) {
  FreeSpace::Obstacles discs;
  for (int i = 0; i < 4; ++i)
    discs.push_back(make_ball({.center = Eigen::Vector2d(2 + 2 * i, 1.5 * std::sin(time + 2 * i)), .radius = 0.6}));
  const auto plane = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  return std::make_shared<FreeSpace>(plane, std::move(discs), 0.05);
}

int main() {
  Problem problem;
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(10, 0);
  problem.cost = make_euclidean_cost(2);
  problem.kernel = make_kernel<Expm1Square>();
  int planned = 0, touching = 0;
  Replanner planner(std::make_shared<Newton>(), std::make_shared<RrtInitializer>(),
                    {.points = 60, .certificate = {.enabled = false}});
  for (int cycle = 0; cycle < 40; ++cycle) {
    problem.manifold = world_at(0.02 * cycle);
    Monitor monitor;
    monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(20);
    const Replan plan = planner.replan(problem, monitor);
    if (plan.outcome == ReplanOutcome::no_valid_path) continue;  // stand still; plan.why_not_new says why
    ++planned;
    touching += plan.clearance->lower < -1e-7 ? 1 : 0;
  }
  std::printf("%d of 40 plans, %d touch\n", planned, touching);
  return planned > 0 && touching == 0 ? 0 : 1;
}
