// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/monitor.hpp>
#include <leastcost/framework/path.hpp>

namespace leastcost {

class PathEnergy;

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
std::string_view name(Termination termination);
/// Whether the chain has come to rest, as far as can be told.
inline bool is_solved(Termination termination) {
  return termination == Termination::converged || termination == Termination::round_off;
}

/// What a solve cost, counted by PathEnergy for every solver alike. One energy or gradient is a whole path.
struct Counters {
  long energies = 0;
  long gradients = 0;
  long hessians = 0;
  long projections = 0;
  long linear_solves = 0;
};

Counters operator+(const Counters& a, const Counters& b);
Counters operator-(const Counters& a, const Counters& b);

/// An unfilled report cannot be mistaken for a result.
struct SolveReport {
  Termination termination = Termination::time_limit;  ///< what else keeps a solver from being called
  std::string message = "there was no time to begin";
  double initial_energy = std::numeric_limits<double>::quiet_NaN();
  double final_energy = std::numeric_limits<double>::quiet_NaN();
  double cost_error = std::numeric_limits<double>::quiet_NaN();  ///< predicted relative cost error at the end
  int iterations = 0;
  bool cycling = false;  ///< what the points keep from obstacles and where they come to rest would not agree
  Counters counters;
  double seconds = 0;
  std::vector<Iteration> history;
};

/// Two solves, one after the other, as one: the counters add up, the end is that of the later one.
SolveReport joined(const SolveReport& earlier, SolveReport later);

/// Improves a path in place. Keeps the best iterate, never returns a higher energy than it was given (methods without
/// an energy: a higher cost), and never throws: not for a numerical outcome, nor when a cost does. After the monitor's
/// deadline the work in hand is abandoned: the path is the last one that was accepted.
class Solver {
 public:
  virtual ~Solver() = default;
  virtual std::string_view name() const = 0;
  /// Whether it looks for a better path at all. For one that stays nothing is fitted to it.
  virtual bool moves_points() const { return true; }
  /// In words, why this solver cannot work on this energy; checked before work starts.
  virtual std::optional<std::string> cannot_solve(const PathEnergy& energy, const CoordinatePath& path) const;
  /// Checks, counts and times do_solve().
  SolveReport solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const;

 private:
  virtual SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const = 0;
  /// do_solve(), unless it is refused, whatever the problem's parts throw. `initial`: out, the energy of the path
  /// handed in.
  SolveReport guarded(PathEnergy& energy, CoordinatePath& path, double& initial, const Monitor& monitor) const;
};

}  // namespace leastcost
