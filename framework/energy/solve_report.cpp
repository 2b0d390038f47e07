// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/solve_report.hpp>

#include <utility>

namespace leastcost {

Words<Termination> words(Termination) {
  using enum Termination;
  static constexpr Word<Termination> kWords[] = {{converged, "converged"},
                                                 {fixed_point, "fixed_point"},
                                                 {round_off, "round_off"},
                                                 {iteration_limit, "iteration_limit"},
                                                 {evaluation_limit, "evaluation_limit"},
                                                 {time_limit, "time_limit"},
                                                 {line_search_failed, "line_search_failed"},
                                                 {non_finite, "non_finite"},
                                                 {collapsed, "collapsed"},
                                                 {exception, "exception"},
                                                 {inconsistent, "inconsistent"},
                                                 {refused, "refused"},
                                                 {cancelled, "cancelled"}};
  return kWords;
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
