// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/ceres/ceres_solver.hpp"

#include "app/back_ends/back_ends.hpp"
#include "app/registration.hpp"

namespace leastcost::app {

SolverPlugin ceres_plugin() { return made_of<SolverPlugin, Ceres, CeresOptions>("ceres", kCeresSummary); }

}  // namespace leastcost::app
