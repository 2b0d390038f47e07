// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/newton/refinement.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/energy/solve_fitted.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/newton/chain_newton.hpp"

namespace leastcost {
namespace {

MaybeChain sample(const Problem& problem, const CoordinatePath& chain, int segments, const Monitor& monitor) {
  return try_sampling(problem, chain, chain.ring ? segments : segments - 1, monitor.limit());
}

double mean_cost(const Problem& problem, const CoordinatePath& path, const Monitor& monitor) {
  return PathEnergy(problem, 1, monitor.limit()).cost(path) / static_cast<double>(path.segment_count());
}

/// As a reference cost: a path may cost nothing, or infinitely much.
bool usable(double s0) { return s0 > 0 && std::isfinite(s0); }

/// A chain that is solved already, on the domain that is fitted to it.
void take_level(const Problem& problem, const CoordinatePath& path, const Monitor& monitor, Refinement& result) {
  const Eigen::VectorXd costs = PathEnergy(problem, 1, monitor.limit()).costs(path);
  result.levels.push_back({static_cast<int>(path.segment_count()), costs.sum(), 0, spread(costs), 0, 0});
  result.paths.push_back(path);
  result.domains.push_back(problem.manifold);
}

/// Solves one level; false where there is nothing to solve, or it came to nothing.
bool solve_level(const Problem& problem, CoordinatePath& path, const Monitor& monitor, Refinement& result) {
  const int segments = static_cast<int>(path.segment_count());
  const std::string which = "the chain with " + std::to_string(segments) + " segments ";
  const double s0 = mean_cost(problem, path, monitor);
  if (!usable(s0)) {
    result.trouble = which + (s0 > 0 ? "has infinite cost" : "has cost 0");
    return false;
  }
  const FittedSolve solved = solve_fitted(problem, ChainNewton(), s0, path, monitor);
  const SolveReport& report = solved.report;
  const Eigen::VectorXd costs = PathEnergy(solved.problem, s0, monitor.limit()).costs(path);
  const Counters& work = report.counters;
  result.levels.push_back(
      {segments, costs.sum(), 0, spread(costs), report.iterations, work.energies + work.gradients + work.hessians});
  result.paths.push_back(path);
  result.domains.push_back(solved.problem.manifold);
  if (!is_solved(report.termination)) result.trouble = which + "ended with " + std::string(word_of(report.termination));
  if (solved.torn) result.trouble = which + "has a move that is far longer than the others: obstacles hold it apart";
  result.collapsed = report.termination == Termination::collapsed;
  return !result.collapsed && !monitor.interrupted();
}

}  // namespace

std::optional<double> solved_cost(const Problem& problem, const CoordinatePath& chain, int segments,
                                  const Monitor& monitor) {
  MaybeChain sampled = sample(problem, chain, segments, monitor);
  if (!sampled) return std::nullopt;  // too few points for this path: there is nothing to compare with
  CoordinatePath& path = *sampled.chain;
  const double s0 = mean_cost(problem, path, monitor);
  if (!usable(s0)) return std::nullopt;
  const FittedSolve solved = solve_fitted(problem, ChainNewton(), s0, path, monitor);
  if (!is_solved(solved.report.termination)) return std::nullopt;
  return PathEnergy(solved.problem, s0, monitor.limit()).cost(path);
}

Refinement refine_levels(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor,
                         const RefinementPlan& plan) {
  Refinement result;
  // Fewer segments than were asked for may not go between obstacles at all.
  const bool fits = find_ability<FitsSegments>(*problem.manifold) != nullptr;
  const int segments = static_cast<int>(chain.segment_count());
  const int coarse = std::max(4, fits ? segments : (segments + 1) / 2);
  const bool begins_solved = plan.is_solved && fits && coarse == segments;
  MaybeChain sampled = begins_solved ? MaybeChain{chain, ""} : sample(problem, chain, coarse, monitor);
  if (!sampled) {
    result.trouble = sampled.why_not;
    result.collapsed = chain.ring && chain.u == chain.u.col(0).replicate(1, chain.u.cols());
    return result;
  }
  CoordinatePath& path = *sampled.chain;
  if (begins_solved) take_level(problem, path, monitor, result);
  for (int k = begins_solved ? 1 : 0; k < 3; ++k) {
    if (k > 0) path = refine(problem, path, monitor.limit());
    if (!solve_level(problem, path, monitor, result)) return result;
  }
  // Half as many segments as the first level: one more difference to judge the others by.
  if (plan.by_order) {
    result.coarser_segments = std::max(chain.ring ? 3 : 2, result.levels[0].segments / 2);
    result.coarser = solved_cost(problem, chain, result.coarser_segments, monitor);
  }
  // Energies of all levels at one s0, that of the middle level, so that they can be compared.
  const double s0 = result.levels[1].cost / result.levels[1].segments;
  if (!usable(s0)) {
    result.trouble = "the chain with " + std::to_string(result.levels[1].segments) + " segments has cost 0";
    return result;
  }
  PathEnergy energy(problem, s0, monitor.limit());
  for (std::size_t k = 0; k < 3; ++k) result.levels[k].energy = energy.value(result.paths[k]);
  return result;
}

}  // namespace leastcost
