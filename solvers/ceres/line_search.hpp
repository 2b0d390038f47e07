// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/solver.hpp>
#include <leastcost/solvers/ceres/ceres_solver.hpp>

namespace leastcost {

SolveReport solve_by_line_search(PathEnergy& energy, CoordinatePath& path, const CeresOptions& options,
                                 const Monitor& monitor);

}  // namespace leastcost
