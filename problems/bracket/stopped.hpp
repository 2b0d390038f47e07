// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace leastcost::bracket {

/// Thrown within a bracket when it is asked to stop; what is proved by then stands.
struct Stopped {};

/// Looks at the request to stop once in so many calls.
class StopLook {
 public:
  explicit StopLook(const std::function<bool()>& stop) : stop_(stop) {}
  void operator()() const {
    if (stop_ && stop_()) throw Stopped();
  }
  /// In the midst of long loops.
  void now_and_then() const {
    constexpr unsigned kOften = 2048;
    if (++calls_ % kOften == 0) (*this)();
  }

 private:
  const std::function<bool()>& stop_;
  mutable unsigned calls_ = 0;
};

}  // namespace leastcost::bracket
