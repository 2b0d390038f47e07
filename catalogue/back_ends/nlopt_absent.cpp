// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/back_ends/back_ends.hpp"

namespace leastcost {

SolverPlugin nlopt_plugin() { return absent("nlopt", kNloptSummary, "libnlopt-cxx-dev"); }

}  // namespace leastcost
