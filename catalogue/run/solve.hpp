// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/catalogue/run/run.hpp>
#include <leastcost/framework/base/monitor.hpp>

namespace leastcost {

/// The search of a composed configuration, within its max_seconds: the path, or the best of its family. Writes nothing.
/// What an interrupted search had no time for, its curve and its costs, is made up for afterwards. Throws
/// InitializationError; StoppedEarly when it was told to stop before there was a path.
RunOutcome solve(Run run, const Monitor& monitor = {});

}  // namespace leastcost
