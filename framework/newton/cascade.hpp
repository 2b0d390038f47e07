// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include "framework/energy/solve_fitted.hpp"

namespace leastcost {

/// Solves coarse first: about 16 segments, then twice as many with cubic prolongation and half the reference cost until
/// the path has those of `path` (docs/numerics.md Sec. 3.7: 17, 4, 3, 3, 3, 3, 3 Newton iterations for the chute from
/// rest). After the monitor's deadline the path is the one given, or that of the last level as far as it came.
/// `reference_cost` is that of the last level. The report is that of the last level; its counters, seconds and
/// history hold all of them.
FittedSolve solve_by_cascade(Problem problem, const Solver& solver, double reference_cost, CoordinatePath& path,
                             const Monitor& monitor);

}  // namespace leastcost
