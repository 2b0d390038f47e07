// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/no_solver.hpp>

#include <cmath>
#include <limits>

#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/energy/stopping.hpp>

namespace leastcost {

SolveReport NoSolver::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  SolveLoop loop(energy, path, {}, monitor);
  const double value = energy.value(path);
  if (!std::isfinite(value)) return loop.finish(Termination::non_finite, "the first path has infinite cost", value);
  loop.record(value, std::numeric_limits<double>::quiet_NaN(), 0);
  return loop.finish(Termination::fixed_point, "the first path unchanged", value);
}

}  // namespace leastcost
