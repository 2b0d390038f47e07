// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/solve_report.hpp>

#include <utility>

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
    case Termination::inconsistent: return "inconsistent";
    case Termination::refused: return "refused";
    case Termination::cancelled: return "cancelled";
  }
  return "unknown";
}

Counters operator+(const Counters& a, const Counters& b) {
  return {a.energies + b.energies, a.gradients + b.gradients, a.hessians + b.hessians, a.projections + b.projections,
          a.linear_solves + b.linear_solves};
}

Counters operator-(const Counters& a, const Counters& b) {
  return a + Counters{-b.energies, -b.gradients, -b.hessians, -b.projections, -b.linear_solves};
}

SolveReport joined(const SolveReport& earlier, SolveReport later) {
  later.counters = earlier.counters + later.counters;
  later.iterations += earlier.iterations;
  later.initial_energy = earlier.initial_energy;
  for (Iteration& line : later.history) {
    line.iteration += earlier.iterations;
    line.evaluations += earlier.counters.energies + earlier.counters.gradients;
    line.seconds += earlier.seconds;
  }
  later.seconds += earlier.seconds;
  later.history.insert(later.history.begin(), earlier.history.begin(), earlier.history.end());
  return later;
}

}  // namespace leastcost
