// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/catalogue/run/run.hpp>

namespace leastcost {

/// The search of solve() for parts that are complete: the path of `outcome.parts`, or the best of their family, within
/// `max_seconds`. Throws InitializationError; StoppedEarly when there is no path yet.
void search(RunOutcome& outcome, std::optional<double> max_seconds, const Monitor& monitor);

}  // namespace leastcost
