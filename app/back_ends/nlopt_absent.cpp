// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/back_ends/back_ends.hpp"

namespace leastcost::app {

SolverPlugin nlopt_plugin() { return absent("nlopt", kNloptSummary, "libnlopt-cxx-dev"); }

}  // namespace leastcost::app
