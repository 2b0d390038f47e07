// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/types.h>

#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/solvers/rounds.hpp>

namespace leastcost {

SolveReport solve_by_line_search(PathEnergy& energy, CoordinatePath& path, ceres::LineSearchDirectionType direction,
                                 const RoundOptions& options, const Monitor& monitor);

}  // namespace leastcost
