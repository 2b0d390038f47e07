// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/solve_chain.hpp"

#include <string>
#include <utility>

#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include "framework/energy/solve_fitted.hpp"
#include "framework/newton/cascade.hpp"
#include "framework/newton/escape_saddle.hpp"

namespace leastcost {
namespace {

/// Only where points can be fitted to obstacles.
double depth_of_moves(const Search& search, const Outcome& out) {
  if (out.failed() || search.monitor.interrupted()) return 0;
  if (find_ability<FitsSegments>(*out.solved.manifold) == nullptr) return 0;
  return depth_in_obstacles(out.solved, out.result.path, search.options.certificate.clearance, search.monitor.limit());
}

}  // namespace

void solve_chain(const Search& search, Outcome& out) {
  timed(Stage::solve, search, out.result.seconds.solve, [&] {
    const double s0 = out.result.reference_cost;
    FittedSolve solved = search.options.cascade
                             ? solve_by_cascade(out.problem, search.solver, s0, out.result.path, search.monitor)
                             : solve_fitted(out.problem, search.solver, s0, out.result.path, search.monitor);
    SolveReport& report = out.result.solve;
    report = report.history.empty() ? std::move(solved.report) : joined(report, std::move(solved.report));
    out.solved = std::move(solved.problem);
    out.torn = solved.torn;
    out.depth = depth_of_moves(search, out);
  });
}

void leave_saddles(const Search& search, Outcome& out) {
  if (!search.options.escape_saddle || out.failed()) return;
  timed(Stage::solve, search, out.result.seconds.solve, [&] {
    Result& result = out.result;
    PathEnergy energy(out.solved, result.reference_cost, search.monitor.limit());
    const int left = escape_saddles(energy, search.solver, search.options.certificate.index_shift, result.path,
                                    result.solve, search.monitor);
    if (left > 0) result.notes.push_back("escape_saddle: left " + std::to_string(left) + " saddles");
    if (!energy.has_exact_hessian())
      result.notes.emplace_back(
          "escape_saddle: a path on a polyhedron, or under H = s, has no index, so a saddle cannot be detected");
  });
}

}  // namespace leastcost
