// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <ctime>
#include <utility>

#include "app/run/run.hpp"

namespace leastcost::app {
namespace {

volatile std::sig_atomic_t stop_flag = 0;
std::time_t first_request = 0;

/// What is said before the program ends at once: plain memory, because a handler may not ask for more.
struct LastWords {
  const char *out = nullptr, *err = nullptr;
  std::size_t out_size = 0, err_size = 0;
};
LastWords final_words;
volatile std::sig_atomic_t ends_at_once = 0;

void say(int stream, const char* text, std::size_t size) {
  while (size > 0) {
    const ssize_t said = ::write(stream, text, size);
    if (said <= 0) return;
    text += said;
    size -= static_cast<std::size_t>(said);
  }
}

/// The first request asks for an orderly end, one made later insists. What follows at once is the same request:
/// timeout(1) and some schedulers signal a process and then its whole group.
extern "C" void on_interrupt(int signal) {
  if (ends_at_once != 0) {
    say(STDERR_FILENO, final_words.err, final_words.err_size);
    say(STDOUT_FILENO, final_words.out, final_words.out_size);
    ::_exit(static_cast<int>(Exit::interrupted));
  }
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

EndsAtOnce::EndsAtOnce(std::string out, std::string err) : out_(std::move(out)), err_(std::move(err)) {
  final_words = {out_.data(), err_.data(), out_.size(), err_.size()};
  ends_at_once = 1;
}

EndsAtOnce::~EndsAtOnce() { ends_at_once = 0; }

}  // namespace leastcost::app
