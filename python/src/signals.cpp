// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/signals.hpp"

#include <thread>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::python {

std::atomic<int> Signals::searches_ = 0;
std::atomic<bool> Signals::ending_ = false;

Signals::Signals() {
  if (ending_) throw InputError("the interpreter is ending: no search can begin");
  ++searches_;
}

Signals::~Signals() { --searches_; }

void Signals::end_all() {
  ending_ = true;
  const pybind11::gil_scoped_release released;
  const Clock::time_point latest = Clock::now() + std::chrono::seconds(5);
  while (searches_ > 0 && Clock::now() < latest) std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

bool Signals::stop() {
  if (ending_) return true;
  if (raised_) return true;
  const Clock::time_point now = Clock::now();
  if (now < next_) return false;
  next_ = now + kEvery;
  const pybind11::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) raised_.emplace();
  return raised_.has_value();
}

void Signals::raise() {
  if (!raised_) return;
  const pybind11::error_already_set exception = *std::exchange(raised_, std::nullopt);
  throw exception;
}

void Signals::deliver() {
  if (raised_ && !raised_->matches(PyExc_KeyboardInterrupt)) raise();
}

}  // namespace leastcost::python
