// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/nlopt/nlopt_solver.hpp"

#include "app/back_ends/back_ends.hpp"
#include "app/registration.hpp"

namespace leastcost::app {

SolverPlugin nlopt_plugin() { return made_of<SolverPlugin, Nlopt, NloptOptions>("nlopt", kNloptSummary); }

}  // namespace leastcost::app
