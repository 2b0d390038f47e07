// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/signals.hpp"

#include <utility>

namespace leastcost::python {

bool Signals::stop() {
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
