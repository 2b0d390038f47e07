// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

/// Leaves saddles: while the index counts a negative direction (docs/numerics.md Sec. 6.4, `shift` is tau), steps along
/// it to both sides, solves again and keeps the better path. `report` is that of the solve before; what is added to it
/// is counted. Returns how many saddles were left. Does nothing on polyhedra and for kernels that are not strictly
/// convex: there is no index.
int escape_saddles(PathEnergy& energy, const Solver& solver, double shift, CoordinatePath& path, SolveReport& report,
                   const Monitor& monitor);

}  // namespace leastcost
