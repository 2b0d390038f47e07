// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

/// The limits every solver shares.
struct Limits {
  double tolerance = 1e-14;      ///< relative cost error g' H^-1 g / (2 sum H'(s_i) s_i), docs/numerics.md Sec. 3.1
  int max_iterations = 1000;     ///< steps at most
  int max_evaluations = 100000;  ///< energies + gradients
};

/// Largest move of a point that still counts as standing still, relative to the path's cost in length.
inline constexpr double kStepTolerance = 1e-8;
/// Largest relative change of a segment that a method may still predict when it stops: the certificate asks for
/// 1e-6, and at the tolerance on the cost alone the spacing is only good to its square root.
inline constexpr double kSpacingTolerance = 2e-7;
/// A ring whose cost has fallen to this part of its first cost has collapsed.
inline constexpr double kCollapse = 1e-6;

/// The bookkeeping of one solve, so that every solver stops, counts and reports alike.
class SolveLoop {
 public:
  SolveLoop(PathEnergy& energy, const CoordinatePath& path, const Limits& limits, const Monitor& monitor);

  /// Writes one line of history and tells the monitor.
  void record(double value, double cost_error, double step);
  /// A better figure than the last recorded one: from the exact Hessian, asked for only at the end.
  void set_cost_error(double cost_error) { report_.cost_error = cost_error; }
  /// A reason to end that has nothing to do with the method: a limit, a stop request, a collapsed ring.
  std::optional<Termination> must_end(const CoordinatePath& path);
  /// Closes the report.
  SolveReport finish(Termination termination, std::string message, double value);

  const Limits& limits() const { return limits_; }          ///< when it ends at the latest
  int iterations() const { return report_.iterations; }     ///< steps so far
  double cost_error() const { return report_.cost_error; }  ///< estimated excess of cost of the last chain, relative

 private:
  long evaluations() const;

  PathEnergy& energy_;
  Limits limits_;
  const Monitor& monitor_;
  Monitor::Clock::time_point start_ = Monitor::Clock::now();
  Counters before_;
  double first_cost_;
  SolveReport report_;
};

}  // namespace leastcost
