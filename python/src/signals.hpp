// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <optional>

namespace leastcost::python {

/// Ctrl-C while a search runs without the GIL: stop() is what the search asks, from the thread that started it.
/// Python's handlers run at most every 20 ms, because taking the GIL has to wait for other threads.
class Signals {
 public:
  /// With the GIL. Throws InputError when the interpreter is ending.
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  /// Before the interpreter ends: stops the searches of daemon threads and waits for them, for five seconds at most.
  /// One that came back later would be torn out of its C++ frames, which ends the process. With the GIL.
  static void end_all();

  /// True once a handler has raised, or the interpreter is ending. Without the GIL.
  bool stop();
  /// Raises what the handler has raised, if it did. With the GIL.
  void raise();
  /// The search has a path to deliver in spite of it: a KeyboardInterrupt is forgotten, other exceptions are raised.
  void deliver();

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kEvery{20};
  static std::atomic<int> searches_;
  static std::atomic<bool> ending_;

  Clock::time_point next_ = Clock::now();
  std::optional<pybind11::error_already_set> raised_;
};

/// The answer of `work(stop)`, which runs without the GIL, on this thread. With the GIL. What a handler raises is
/// raised here: half a search proves nothing, and half a mesh is none.
template <class Work>
auto interruptible(Work work) {
  Signals signals;
  const std::function<bool()> stop = [&signals] { return signals.stop(); };
  auto made = [&] {
    try {
      const pybind11::gil_scoped_release released;
      return work(stop);
    } catch (const std::exception&) {
      signals.raise();
      throw;
    }
  }();
  signals.raise();
  return made;
}

}  // namespace leastcost::python
