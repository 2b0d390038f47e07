// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include <leastcost/framework/global_bound.hpp>
#include <leastcost/framework/monitor.hpp>

namespace leastcost {

/// When a search over all paths has to end: after the seconds of its budget, and half of what is left before the
/// deadline of the run, for the certificate needs the rest.
inline Deadline end_of_search(const GlobalBudget& budget, const Monitor& monitor) {
  constexpr double kShare = 0.5;
  const auto begin = Monitor::Clock::now();
  double seconds = budget.max_seconds.value_or(std::numeric_limits<double>::infinity());
  if (monitor.deadline)
    seconds = std::min(seconds, kShare * std::chrono::duration<double>(*monitor.deadline - begin).count());
  if (seconds == std::numeric_limits<double>::infinity()) return {};
  return begin + std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace leastcost
