// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solve_report.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

class PathEnergy;

/// Improves a path in place. Keeps the best iterate, never returns a higher energy than it was given (methods without
/// an energy: a higher cost), and never throws: not for a numerical outcome, nor when a cost does. After the monitor's
/// deadline the work in hand is abandoned: the path is the last one that was accepted.
class Solver {
 public:
  virtual ~Solver() = default;
  virtual std::string_view name() const = 0;  ///< its name in configurations
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
