// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost::app {

/// From now on the first SIGINT or SIGTERM only sets a flag, so that a run can end with its best path written; the
/// second one ends the program as usual.
void catch_interrupts();
bool interrupted();

}  // namespace leastcost::app
