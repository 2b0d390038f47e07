// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

/// When a time budget ends; nothing: never.
using Deadline = std::optional<std::chrono::steady_clock::time_point>;

/// Throws Interrupted once the deadline has passed. For the midst of long passes, whose work is then thrown away.
inline void look_at_clock(const Deadline& deadline) {
  if (deadline && std::chrono::steady_clock::now() >= *deadline) throw Interrupted("the time budget is used up");
}

}  // namespace leastcost
