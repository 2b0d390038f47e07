// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/global_bound.hpp>

namespace leastcost {

/// When a search over all paths has to end: after the seconds of its budget, and half of what is left before the
/// deadline of the run, for the certificate needs the rest.
inline Deadline end_of_search(const GlobalBudget& budget, const Monitor& monitor) {
  constexpr double kShare = 0.5, kForEver = 1e9;  // s; a clock does not count much further
  const auto begin = Monitor::Clock::now();
  double seconds = budget.max_seconds.value_or(std::numeric_limits<double>::infinity());
  if (monitor.deadline)
    seconds = std::min(seconds, kShare * std::chrono::duration<double>(*monitor.deadline - begin).count());
  if (seconds > kForEver) return {};
  return begin + std::chrono::duration_cast<Monitor::Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Whether such a search that begins now has to end. Holds on to the monitor.
inline std::function<bool()> stop_of_search(const GlobalBudget& budget, const Monitor& monitor) {
  return [&monitor, end = end_of_search(budget, monitor)] {
    return monitor.interrupted() || (end && Monitor::Clock::now() > *end);
  };
}

}  // namespace leastcost
