// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/energy/solve_fitted.hpp"

#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/domain/in_parts.hpp"
#include "framework/energy/spacing.hpp"

namespace leastcost {
namespace {

constexpr int kMostFits = 16;
constexpr int kMostUnsolved = 2;  ///< fits to a chain that is not at rest say little

/// Onto the domain, but for the ends of an open path, which are given. The number of points that found no place there.
std::size_t project_free(const ConstraintManifold& manifold, CoordinatePath& path, const Monitor& monitor) {
  CoordinatePath moved = path;
  const Projection projection = project(manifold, moved, monitor.limit());
  const Index first = path.free_begin(), count = path.free_count();
  path.u.middleCols(first, count) = moved.u.middleCols(first, count);
  return projection.failed.size();
}

/// With so many a solve leads nowhere.
bool are_too_many(std::size_t without_room, const CoordinatePath& path) {
  constexpr double kMost = 0.1;  // of the points
  return static_cast<double>(without_room) > kMost * static_cast<double>(path.free_count());
}

SolveReport no_room_for(std::size_t points) {
  SolveReport report;
  report.termination = Termination::line_search_failed;
  report.message =
      "obstacles leave no room for " + std::to_string(points) + " of its points; more points keep less away";
  return report;
}

/// A solver spaces points equally, unless walls keep neighbours from each other.
bool is_torn(PathEnergy& energy, const CoordinatePath& path) {
  constexpr double kTorn = 2.5;  // of the mean
  const Eigen::VectorXd costs = energy.costs(path);
  return costs.maxCoeff() > kTorn * costs.mean();
}

/// Points that were pushed out of walls are spaced equally again where that has stretched a segment: a solver with an
/// exponential kernel needs an iteration for each factor e that a segment's energy stands out by.
void space_pushed(const Problem& problem, CoordinatePath& path, const Deadline& deadline) {
  constexpr double kStretched = 1.5;  // of the mean
  PathEnergy energy(problem, 1, deadline);
  const auto stretch = [&](const CoordinatePath& p) {
    const Eigen::VectorXd costs = energy.costs(p);
    return costs.maxCoeff() / costs.mean();
  };
  const double before = stretch(path);
  if (!(before > kStretched)) return;
  MaybeChain spaced = try_sampling(problem, path, {static_cast<int>(path.free_count()), kStretched - 1}, deadline);
  if (spaced && stretch(*spaced.chain) < before) path = std::move(*spaced.chain);
}

/// With the margins of the last chain, where they are of this domain.
bool start_with(const Fitting& fitting, Problem& problem, CoordinatePath& path, const Deadline& deadline) {
  const auto* reuses = find_ability<ReusesMargins>(*problem.manifold);
  if (reuses == nullptr || fitting.kept == nullptr) return false;
  auto domain = reuses->unfitted_with(*fitting.kept, path, fitting.agreement);
  if (domain == nullptr) return false;
  find_ability<ReusesMargins>(*domain)->carry_along(*fitting.kept, path, deadline);
  problem.manifold = std::move(domain);
  return true;
}

}  // namespace

FittedSolve solve_fitted(Problem problem, const Solver& solver, double reference_cost, CoordinatePath& path,
                         const Monitor& monitor, const Fitting& fitting) {
  const auto* domain = find_ability<FitsSegments>(*problem.manifold);
  const bool fits = domain != nullptr && solver.moves_points();
  Points agreed;  // the chain to which the domain was fitted without a change: looking again would say the same
  const bool warm = fits && start_with(fitting, problem, path, monitor.limit());
  if (fits && !warm) {  // to the path as it is, too: a move through an obstacle could not be drawn out of it
    problem.manifold = domain->unfitted(path, fitting.agreement);
    const std::size_t without_room = project_free(*problem.manifold, path, monitor);
    if (are_too_many(without_room, path)) return {no_room_for(without_room), std::move(problem), true};
    space_pushed(problem, path, monitor.limit());
    SegmentFit fit = find_ability<FitsSegments>(*problem.manifold)->fitted(path);
    if (fit.domain != nullptr)
      problem.manifold = std::move(fit.domain);
    else
      agreed = path.u;
  }
  SolveReport report;
  SegmentFit fit;
  bool torn = false;
  int unsolved = 0;
  for (int k = 0;; ++k) {
    if (fits && agreed.size() == 0) {
      const std::size_t without_room = project_free(*problem.manifold, path, monitor);
      if (k == 0 && are_too_many(without_room, path)) return {no_room_for(without_room), std::move(problem), true};
      space_pushed(problem, path, monitor.limit());
    }
    PathEnergy energy(problem, reference_cost, monitor.limit());
    SolveReport next = solver.solve(energy, path, monitor);
    report = k == 0 ? std::move(next) : joined(report, std::move(next));
    if (!fits || report.termination == Termination::exception || monitor.interrupted()) break;
    if (agreed.size() == path.u.size() && agreed == path.u) break;
    agreed.resize(0, 0);
    if (!is_solved(report.termination) && ++unsolved == kMostUnsolved) break;
    fit = find_ability<FitsSegments>(*problem.manifold)->fitted(path);
    if (fit.domain == nullptr || (torn = is_torn(energy, path))) break;
    if (k + 1 == kMostFits) {
      report.cycling = true;
      break;
    }
    problem.manifold = std::move(fit.domain);
  }
  return {std::move(report), std::move(problem), torn, std::move(fit.gaps)};
}

}  // namespace leastcost
