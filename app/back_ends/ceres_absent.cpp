// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/back_ends/back_ends.hpp"

namespace leastcost::app {

SolverPlugin ceres_plugin() { return absent("ceres", kCeresSummary, "libceres-dev"); }

}  // namespace leastcost::app
