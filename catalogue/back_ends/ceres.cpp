// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/ceres/ceres_solver.hpp>

#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

SolverPlugin ceres_plugin() { return made_of<SolverPlugin, Ceres, CeresOptions>("ceres", kCeresSummary); }

}  // namespace leastcost
