// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "framework/solver.hpp"
#include "solvers/ceres/ceres_solver.hpp"

namespace leastcost {

SolveReport solve_by_trust_region(PathEnergy& energy, CoordinatePath& path, const CeresOptions& options,
                                  const Monitor& monitor);

}  // namespace leastcost
