// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/certificate/geometry_error.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/domain/in_parts.hpp"
#include "framework/newton/chain_newton.hpp"

namespace leastcost {
namespace {

constexpr double kSafety = 2;

/// The cost of the chain solved on another version of the domain, or why there is none.
struct Solved {
  std::optional<double> cost;
  std::string trouble;
};

Solved solve_on(std::shared_ptr<const ConstraintManifold> manifold, const Problem& problem, CoordinatePath path,
                const Monitor& monitor) {
  Problem coarse = problem;
  coarse.manifold = std::move(manifold);
  if (const auto* cost = find_ability<FollowsDomain>(*problem.cost)) coarse.cost = cost->on(*coarse.manifold);
  if (!problem.ring) {
    coarse.source = project_end(*coarse.manifold, problem.source.u);
    coarse.target = project_end(*coarse.manifold, problem.target.u);
  }
  path.sites.clear();
  if (!leastcost::project(*coarse.manifold, path, monitor.limit()).failed.empty())
    return {std::nullopt, "a point of the path has no counterpart on it"};
  pin_ends(coarse, path);
  const double cost = PathEnergy(coarse, 1, monitor.limit()).cost(path);
  if (!(cost > 0) || !std::isfinite(cost))
    return {std::nullopt, cost > 0 ? "the chain on it has infinite cost" : "the chain on it has cost 0"};
  PathEnergy energy(coarse, cost / static_cast<double>(path.segment_count()), monitor.limit());
  const SolveReport report = ChainNewton().solve(energy, path, monitor);
  if (report.termination != Termination::converged && report.termination != Termination::round_off)
    return {std::nullopt, "the chain on it ended with " + std::string(word_of(report.termination))};
  return {energy.cost(path), ""};
}

/// How much the cost changes when each point alone moves to its foot on the coarser version, by central differences,
/// without letting the points cancel each other.
double change_without_cancelling(const Problem& problem, const ConstraintManifold& manifold,
                                 const CoordinatePath& chain, const Deadline& deadline) {
  CoordinatePath moved = chain;
  moved.sites.clear();
  project(manifold, moved, deadline);
  const Index columns = chain.u.cols();
  PathEnergy energy(problem, 1, deadline);
  CoordinatePath three{Points(chain.u.rows(), 3), {}, false};
  if (!chain.sites.empty()) three.sites.resize(3);
  double sum = 0;
  for (Index i = chain.free_begin(); i < chain.free_begin() + chain.free_count(); ++i) {
    for (Index k = 0; k < 3; ++k) {
      const Index column = (i + k - 1 + columns) % columns;
      three.u.col(k) = chain.u.col(column);
      if (!chain.sites.empty()) three.sites[static_cast<std::size_t>(k)] = chain.site(column);
    }
    const Eigen::VectorXd step = moved.u.col(i) - chain.u.col(i);
    three.u.col(1) = chain.u.col(i) + step;
    const double there = energy.cost(three);
    three.u.col(1) = chain.u.col(i) - step;
    const double change = std::abs(there - energy.cost(three)) / 2;
    if (std::isfinite(change)) sum += change;
  }
  return sum;
}

/// The next coarser version; null where there is none. To make one takes too long for a search with a deadline.
std::shared_ptr<const ConstraintManifold> coarser(const ConstraintManifold& manifold, const Deadline& deadline) {
  const auto* domain = find_ability<HasCoarserVersion>(manifold);
  if (domain == nullptr) return nullptr;
  if (deadline && !domain->has_made_coarser())
    throw InputError("it was not made in advance; call prepare(problem) before a search with a deadline");
  return domain->coarser();
}

}  // namespace

GeometryError measure_geometry_error(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor) {
  std::optional<double> largest;
  double finer = PathEnergy(problem, 1, monitor.limit()).cost(chain), part = 1;
  std::shared_ptr<const ConstraintManifold> manifold = problem.manifold;
  for (int level = 0; level < kGeometryLevels; ++level, part /= 2) {
    Solved solved;
    try {
      manifold = coarser(*manifold, monitor.deadline);
      if (!manifold) break;
      solved = solve_on(manifold, problem, chain, monitor);
    } catch (const InputError& error) {
      solved.trouble = error.what();
    }
    if (!solved.cost && !largest) return {std::nullopt, "on a coarser version of the domain: " + solved.trouble};
    if (!solved.cost) break;  // too little is left: the first difference has to do
    largest = std::max(largest.value_or(0), part * std::abs(*solved.cost - finer));
    if (level == 0) largest = std::max(*largest, change_without_cancelling(problem, *manifold, chain, monitor.limit()));
    finer = *solved.cost;
  }
  if (!largest) return {};
  return {kSafety * *largest, ""};
}

std::string why_unresolved(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor) {
  const auto* domain = find_ability<HasUnresolvedPlaces>(*problem.manifold);
  if (domain == nullptr) return "";
  constexpr Index kPart = 8;
  std::string why;
  in_parts(chain.segment_count(), kPart, monitor.limit(), [&](Index begin, Index count) {
    if (!why.empty()) return;
    CoordinatePath part{Points(chain.u.rows(), 2 * count + 1), {}, true};
    for (Index i = 0; i < count; ++i) {
      part.u.col(2 * i) = chain.column(begin + i);
      part.u.col(2 * i + 1) = (chain.column(begin + i) + chain.column(begin + i + 1)) / 2;
    }
    part.u.col(2 * count) = chain.column(begin + count);
    why = domain->why_unresolved(part);
  });
  return why;
}

}  // namespace leastcost
