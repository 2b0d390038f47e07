// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/back_ends/back_ends.hpp"

namespace leastcost {

SolverPlugin ceres_plugin() { return absent("ceres", kCeresSummary, "libceres-dev"); }

}  // namespace leastcost
