// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/plans/other_plans.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdint>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include "ompl/plans/plan_roadmap.hpp"
#include "ompl/plans/plan_trees.hpp"
#include "ompl/plans/tighten.hpp"
#include "problems/initializers/random_trees.hpp"

namespace leastcost {
namespace {

constexpr int kMostNodes = 3000;                        ///< of all trees
constexpr int kMostPulled = 4;                          ///< plans
constexpr int kPlaces = 25;                             ///< on a plan, between which shortcuts are looked for
constexpr double kRoughly = 1e-2;                       ///< a pull that gains less of the length is the last
constexpr int kMostPosePlans = 8;                       ///< of trees, where places are poses
constexpr double kLongestMove = 0.1;                    ///< of the cheapest plan, between places of two plans
constexpr double kForTrees = 0.2, kForPulls = 2.0 / 3;  ///< of the time that is left at first

struct Plan {
  Points x;
  double cost = 0;
  bool clear = false;
  bool operator<(const Plan& other) const { return std::tuple(!clear, cost) < std::tuple(!other.clear, other.cost); }
};

Plan plan_of(const PlanSpace& space, Points x) {
  Plan plan{std::move(x), 0, false};
  plan.cost = space.cost(plan.x);
  plan.clear = all_move(space, plan.x);
  return plan;
}

Monitor within(double share, const Monitor& monitor) {
  Monitor part = monitor;
  const auto now = Monitor::Clock::now();
  if (monitor.deadline)
    part.deadline = now + std::chrono::duration_cast<Monitor::Clock::duration>(share * (*monitor.deadline - now));
  return part;
}

void add_plans(const PlanSpace& space, const Problem& problem, int trees, const Monitor& monitor,
               std::vector<Plan>& plans) {
  constexpr std::uint64_t kNextSeed = 0x9E3779B97F4A7C15;  // far from the seeds that people take
  const RrtOptions options;
  std::uint64_t seed = 0;
  int nodes = 0;
  try {
    for (int k = 0; k < trees && nodes < kMostNodes && !monitor.interrupted(); ++k) {
      RandomTrees grown(problem, options, seed += kNextSeed);
      const auto joined = grown.joined(kMostNodes - nodes, monitor);
      nodes += grown.size();
      if (!joined) continue;
      const std::vector<Eigen::VectorXd> path = grown.shortened(*joined, monitor);
      Points x(problem.source.u.size(), static_cast<Index>(path.size()));
      for (Index i = 0; i < x.cols(); ++i) x.col(i) = path[static_cast<std::size_t>(i)];
      plans.push_back({std::move(x), 0, true});
      plans.back().cost = space.cost(plans.back().x);
    }
  } catch (const Interrupted&) {  // there is the given plan
  }
}

/// The same for the same plan, and others for another one.
std::uint64_t seed_of(const Points& x) {
  std::uint64_t seed = 0xCBF29CE484222325;  // Fowler, Noll and Vo
  for (const double value : x.reshaped()) seed = (seed ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001B3;
  return seed;
}

double length_of(const Points& x) {
  return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
}

/// Pulling takes long among poses, and shortcuts of one plan stay beside it. The best pieces of several, put together,
/// are nearly always cheaper than each of them.
Points put_together(const PlanSpace& space, const Points& given, int trees, const Monitor& for_trees,
                    const Monitor& for_pulls) {
  std::vector<Plan> plans;
  if (all_move(space, given)) plans.push_back({given, space.cost(given), true});
  std::mt19937_64 seeds(seed_of(given));
  for (int k = 0; k < std::min(trees, kMostPosePlans) && !for_trees.interrupted(); ++k) {
    const auto found = random_plan(space, given.col(0), given.rightCols(1), seeds(), kMostNodes, for_trees);
    if (!found) continue;
    Plan plan = plan_of(space, with_shortcuts(space, *found, kPlaces, for_trees));
    if (plan.clear) plans.push_back(std::move(plan));
  }
  if (plans.empty()) return given;
  const Plan& best = *std::min_element(plans.begin(), plans.end());
  PlanRoadmap map(space, given.col(0), given.rightCols(1), kLongestMove * length_of(best.x));
  for (const Plan& plan : plans) map.add_path(divided(space, plan.x, kPlaces));
  const Points together = map.cheapest(for_pulls);
  return together.cols() > 1 ? together : best.x;
}

}  // namespace

bool can_plan(const PlanSpace& space) {
  return (space.is_flat() || space.has_random_places()) && space.walls() != nullptr &&
         find_ability<DecidesMoves>(*space.walls()) != nullptr &&
         find_ability<HasConstantMetric>(space.move_costs()) != nullptr;
}

Points cheapest_plan(const PlanSpace& space, const Problem& problem, const Points& given, int trees,
                     const Monitor& monitor) {
  const Monitor for_trees = within(kForTrees, monitor), for_pulls = within(kForPulls, monitor);
  if (!space.is_flat()) return put_together(space, given, trees, for_trees, for_pulls);
  std::vector<Plan> plans = {plan_of(space, given)};
  add_plans(space, problem, trees, for_trees, plans);
  std::sort(plans.begin(), plans.end());
  if (plans.size() > kMostPulled) plans.resize(kMostPulled);
  for (Plan& plan : plans)
    if (!for_pulls.interrupted()) plan = plan_of(space, with_shortcuts(space, plan.x, kPlaces, for_pulls));
  std::sort(plans.begin(), plans.end());
  for (Plan& plan : plans)
    if (!for_pulls.interrupted()) plan = plan_of(space, pulled_among_walls(space, plan.x, for_pulls, kRoughly));
  return std::min_element(plans.begin(), plans.end())->x;
}

}  // namespace leastcost
