// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <exception>
#include <utility>

namespace leastcost::python {

/// The first exception that a function written in Python has raised in one run, from whatever thread. The libraries may
/// swallow exceptions, and a certificate does.
class CallErrors {
 public:
  /// Whether there was one: the search cannot go on, and no function is called any more. With or without the GIL.
  bool any() const { return any_; }
  /// Keeps it, if it is the first. With the GIL.
  void keep(std::exception_ptr exception) {
    if (!over_ && !any_.exchange(true)) first_ = std::move(exception);
  }
  /// Raises it, if there was one, with its traceback. With the GIL.
  void raise() {
    if (first_) std::rethrow_exception(std::exchange(first_, nullptr));
  }
  /// The run is over: whoever calls a function now hears of its exceptions himself.
  void end() { over_ = true; }

 private:
  std::atomic<bool> any_ = false, over_ = false;
  std::exception_ptr first_;  // guarded by the GIL
};

}  // namespace leastcost::python
