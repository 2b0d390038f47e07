// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>

#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

SolverPlugin nlopt_plugin() { return made_of<SolverPlugin, Nlopt, NloptOptions>("nlopt", kNloptSummary); }

}  // namespace leastcost
