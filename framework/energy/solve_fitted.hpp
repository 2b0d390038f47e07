// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Solves a chain. Where the domain fits segments, the chain and what the domain is fitted to are made to agree:
/// `problem` is left with the domain that the chain was solved on.
SolveReport solve_fitted(Problem& problem, const Solver& solver, double reference_cost, CoordinatePath& path,
                         const Monitor& monitor);

}  // namespace leastcost
