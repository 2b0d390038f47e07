// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/types.h>

#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/solvers/rounds.hpp>

namespace leastcost {

SolveReport solve_by_trust_region(PathEnergy& energy, CoordinatePath& path, ceres::TrustRegionStrategyType strategy,
                                  const RoundOptions& rounds, int max_iterations, const Monitor& monitor);

}  // namespace leastcost
