// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/interrupt.hpp"

#include <csignal>

namespace leastcost::app {
namespace {

volatile std::sig_atomic_t stop_flag = 0;

extern "C" void on_interrupt(int) {
  stop_flag = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

bool interrupted() { return stop_flag != 0; }

}  // namespace leastcost::app
