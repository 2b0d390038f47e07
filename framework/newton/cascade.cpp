// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/cascade.hpp"

#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include "framework/energy/solve_fitted.hpp"
#include "framework/energy/spacing.hpp"

namespace leastcost {
namespace {

constexpr Index kCoarsest = 16;  ///< segments of the first level, about

/// Segments per level, coarse to fine: halved, rounding up, until about kCoarsest.
std::vector<Index> level_sizes(Index finest) {
  std::vector<Index> sizes{finest};
  while (sizes.back() >= 2 * kCoarsest) sizes.push_back((sizes.back() + 1) / 2);
  return {sizes.rbegin(), sizes.rend()};
}

}  // namespace

FittedSolve solve_by_cascade(Problem problem, const Solver& solver, double reference_cost, CoordinatePath& path,
                             const Monitor& monitor) {
  const Index finest = path.segment_count();
  const auto points = [&path](Index segments) { return static_cast<int>(path.ring ? segments : segments - 1); };
  const auto next_level = [&](const CoordinatePath& before, Index segments) {
    if (before.u.size() == 0)
      return segments == finest ? path : sample_equally(problem, path, points(segments), monitor.limit());
    CoordinatePath level = refine(problem, before, monitor.limit());
    if (level.segment_count() == segments) return level;
    return sample_equally(problem, level, {points(segments), 1e-3}, monitor.limit());
  };
  SolveReport report;
  CoordinatePath level;
  for (const Index segments : level_sizes(finest)) {
    try {
      level = next_level(level, segments);
    } catch (const Interrupted&) {
      report.termination = monitor.cancelled() ? Termination::cancelled : Termination::time_limit;
      report.message = "";
      return {std::move(report), std::move(problem)};
    }
    const double s0 = reference_cost * static_cast<double>(finest) / static_cast<double>(segments);
    FittedSolve next = solve_fitted(std::move(problem), solver, s0, level, monitor);
    problem = std::move(next.problem);
    report = report.history.empty() ? std::move(next.report) : joined(report, std::move(next.report));
    if (monitor.interrupted() || report.termination == Termination::exception) break;
  }
  if (level.segment_count() == finest) path = std::move(level);
  return {std::move(report), std::move(problem)};
}

}  // namespace leastcost
