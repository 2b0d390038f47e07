// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/solver.hpp"

#include <chrono>
#include <cmath>

#include "framework/path_energy.hpp"

namespace leastcost {

std::string_view name(Termination termination) {
  switch (termination) {
    case Termination::converged: return "converged";
    case Termination::fixed_point: return "fixed_point";
    case Termination::round_off: return "round_off";
    case Termination::iteration_limit: return "iteration_limit";
    case Termination::evaluation_limit: return "evaluation_limit";
    case Termination::time_limit: return "time_limit";
    case Termination::line_search_failed: return "line_search_failed";
    case Termination::non_finite: return "non_finite";
    case Termination::collapsed: return "collapsed";
    case Termination::exception: return "exception";
    case Termination::cancelled: return "cancelled";
  }
  return "unknown";
}

std::optional<std::string> Solver::cannot_solve(const PathEnergy&, const CoordinatePath&) const { return std::nullopt; }

SolveReport Solver::solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  const auto start = Monitor::Clock::now();
  SolveReport report;
  const Counters before = energy.counters();
  const double initial = energy.value(path);
  if (const std::optional<std::string> reason = cannot_solve(energy, path)) {
    report.message = *reason;
  } else if (!std::isfinite(initial)) {
    report.message = "the energy of the first path is not finite";
  } else {
    report = guarded(energy, path, monitor);
  }
  report.initial_energy = initial;
  const Counters& now = energy.counters();
  report.counters = {now.energies - before.energies, now.gradients - before.gradients, now.hessians - before.hessians,
                     now.projections - before.projections, now.linear_solves - before.linear_solves};
  report.seconds = std::chrono::duration<double>(Monitor::Clock::now() - start).count();
  return report;
}

/// do_solve(), whatever the problem's parts throw. The path is then the last one that was accepted.
SolveReport Solver::guarded(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  const CoordinatePath start = path;
  const double initial = energy.value(path);
  SolveReport report;
  try {
    return do_solve(energy, path, monitor);
  } catch (const std::exception& error) {
    report.message = error.what();
  }
  report.termination = Termination::exception;
  report.final_energy = initial;
  try {
    report.final_energy = energy.value(path);
  } catch (const std::exception&) {
    path = start;
  }
  if (!(report.final_energy <= initial)) {
    path = start;
    report.final_energy = initial;
  }
  return report;
}

SolveReport joined(const SolveReport& earlier, SolveReport later) {
  const Counters &a = earlier.counters, &b = later.counters;
  later.counters = {a.energies + b.energies, a.gradients + b.gradients, a.hessians + b.hessians,
                    a.projections + b.projections, a.linear_solves + b.linear_solves};
  later.iterations += earlier.iterations;
  later.initial_energy = earlier.initial_energy;
  for (Iteration& line : later.history) {
    line.iteration += earlier.iterations;
    line.evaluations += a.energies + a.gradients;
    line.seconds += earlier.seconds;
  }
  later.seconds += earlier.seconds;
  later.history.insert(later.history.begin(), earlier.history.begin(), earlier.history.end());
  return later;
}

}  // namespace leastcost
