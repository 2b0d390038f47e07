// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/base/words.hpp>

namespace leastcost {

/// Why a solve ended. Never a bool: a limit is not convergence.
enum class Termination {
  converged,    ///< the stopping test of docs/numerics.md Sec. 3.1 holds
  fixed_point,  ///< a method with a functional of its own has come to rest
  round_off,    ///< no further decrease can be told from rounding
  iteration_limit,
  evaluation_limit,
  time_limit,
  line_search_failed,
  non_finite,  ///< the energy of the path handed in is not finite
  collapsed,   ///< the ring has shrunk to a point
  exception,   ///< a cost, kernel or manifold threw; the message is its own
  refused,     ///< the solver cannot work on this problem; the message says why
  cancelled,
  /// The values of the cost and its gradient are of two functions; the message has both energies.
  inconsistent
};
Words<Termination> words(Termination);
/// Whether the chain has come to rest, as far as can be told.
inline bool is_solved(Termination termination) {
  return termination == Termination::converged || termination == Termination::round_off;
}

/// What a solve cost, counted by PathEnergy for every solver alike. One energy or gradient is a whole path.
struct Counters {
  long energies = 0;       ///< evaluations of the energy
  long gradients = 0;      ///< evaluations of its gradient
  long hessians = 0;       ///< evaluations of its Hessian
  long projections = 0;    ///< projections onto the domain
  long linear_solves = 0;  ///< systems solved
};

Counters operator+(const Counters& a, const Counters& b);
Counters operator-(const Counters& a, const Counters& b);

/// An unfilled report cannot be mistaken for a result.
struct SolveReport {
  Termination termination = Termination::time_limit;                 ///< what else keeps a solver from being called
  std::string message = "there was no time to start";                ///< why it ended, in words
  double initial_energy = std::numeric_limits<double>::quiet_NaN();  ///< energy of the first path
  double final_energy = std::numeric_limits<double>::quiet_NaN();    ///< energy of the last chain
  double cost_error = std::numeric_limits<double>::quiet_NaN();      ///< predicted relative cost error at the end
  int iterations = 0;                                                ///< steps that were taken
  bool cycling = false;            ///< what the points keep from obstacles and where they come to rest would not agree
  Counters counters;               ///< work that was done
  double seconds = 0;              ///< wall time
  std::vector<Iteration> history;  ///< one entry for every step, if it was asked for
};

/// Two solves, one after the other, as one: the counters add up, the end is that of the later one.
SolveReport joined(const SolveReport& earlier, SolveReport later);

}  // namespace leastcost
