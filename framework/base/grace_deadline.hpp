// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>

#include <leastcost/framework/base/deadline.hpp>

namespace leastcost {

/// What may still be measured of an interrupted path: until so many parts of a thirty-third of the budget after the
/// deadline, at least 0.3 ms each. The contract of find_path() leaves a tenth.
inline Deadline grace_deadline(const Deadline& deadline, std::chrono::steady_clock::time_point start, int parts) {
  using Clock = std::chrono::steady_clock;
  constexpr auto kLeast = std::chrono::microseconds(300);
  constexpr int kPart = 33;
  if (!deadline.time()) return {};
  return *deadline + parts * std::max<Clock::duration>(kLeast, (*deadline - start) / kPart);
}

}  // namespace leastcost
