// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <csignal>
#include <ctime>

#include <leastcost/framework/base/monitor.hpp>

namespace leastcost::test {

/// Seconds of thread time that a call needs beyond a deadline, however busy the machine is: a timer interrupts this
/// thread at the deadline, and the handler reads the clock of the thread. One at a time.
class Overrun {
 public:
  explicit Overrun(Monitor::Clock::time_point deadline) {
    struct sigaction action = {};
    action.sa_handler = [](int) { at_deadline() = now(); };
    action.sa_flags = SA_RESTART;
    sigaction(SIGRTMIN, &action, &before_);
    sigevent event = {};
    event.sigev_notify = SIGEV_THREAD_ID;
    event.sigev_signo = SIGRTMIN;
    event._sigev_un._tid = gettid();
    timer_create(CLOCK_MONOTONIC, &event, &timer_);  // that of steady_clock
    at_deadline() = -1;
    const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(deadline.time_since_epoch()).count();
    itimerspec when = {};
    when.it_value.tv_sec = ns / 1'000'000'000;
    when.it_value.tv_nsec = ns % 1'000'000'000;
    timer_settime(timer_, TIMER_ABSTIME, &when, nullptr);
  }
  ~Overrun() {
    timer_delete(timer_);
    sigaction(SIGRTMIN, &before_, nullptr);
  }
  Overrun(const Overrun&) = delete;
  Overrun& operator=(const Overrun&) = delete;

  /// Until now; 0 before the deadline.
  double seconds() const {
    const double end = now();
    return at_deadline() < 0 ? 0 : end - at_deadline();
  }

 private:
  static double now() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  static volatile double& at_deadline() {
    static volatile double seconds = -1;
    return seconds;
  }

  timer_t timer_{};
  struct sigaction before_ = {};
};

/// Of a call.
template <class Call>
double overrun(Monitor::Clock::time_point deadline, Call call) {
  const Overrun watch(deadline);
  call();
  return watch.seconds();
}

}  // namespace leastcost::test
