// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace leastcost {

inline double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// When a run began, on both clocks.
struct RunStart {
  std::chrono::steady_clock::time_point clock = std::chrono::steady_clock::now();
  std::chrono::system_clock::time_point time = std::chrono::system_clock::now();
};

}  // namespace leastcost
