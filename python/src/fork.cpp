// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/fork.hpp"

#include <pthread.h>
#include <pybind11/pybind11.h>

#include <optional>

namespace leastcost::python {
namespace {

thread_local bool forks_python = false;
thread_local std::optional<pybind11::gil_scoped_acquire> held;

void before_fork() {
  if (!forks_python) return;
  held.emplace();
  PyOS_BeforeFork();
}

void after_fork_in_parent() {
  if (!forks_python) return;
  PyOS_AfterFork_Parent();
  held.reset();
}

void after_fork_in_child() {
  if (!forks_python) return;
  PyOS_AfterFork_Child();
  held.reset();
}

}  // namespace

ForksPython::ForksPython() {
  static const int registered = ::pthread_atfork(before_fork, after_fork_in_parent, after_fork_in_child);
  static_cast<void>(registered);
  forks_python = true;
}

ForksPython::~ForksPython() { forks_python = false; }

}  // namespace leastcost::python
