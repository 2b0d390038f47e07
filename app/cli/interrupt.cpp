// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/interrupt.hpp"

#include <csignal>
#include <ctime>

namespace leastcost::app {
namespace {

volatile std::sig_atomic_t stop_flag = 0;
std::time_t first_request = 0;

/// The first request asks for an orderly end, one made later insists. What follows at once is the same request:
/// timeout(1) and some schedulers signal a process and then its whole group.
extern "C" void on_interrupt(int signal) {
  if (stop_flag == 0) {
    stop_flag = 1;
    first_request = std::time(nullptr);
  } else if (std::time(nullptr) > first_request + 1) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

bool interrupted() { return stop_flag != 0; }

}  // namespace leastcost::app
