// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>

namespace leastcost::python {

class PythonCost;

/// The first exception that a function written in Python has raised in one run, from whatever thread, and the costs
/// that hold such functions. The libraries may swallow exceptions, and a certificate does.
class CallErrors {
 public:
  /// Whether there was one: the search cannot go on, and no function is called any more. With or without the GIL.
  bool any() const { return any_; }
  /// Keeps it, if it is the first, or the first one again with more of its traceback: that of a cost comes through a
  /// solver. With the GIL.
  void keep(const std::exception_ptr& exception) {
    if (!over_ && (!any_.exchange(true) || is_first(exception))) first_ = exception;
  }
  /// Raises it, if there was one, with its traceback. With the GIL.
  void raise() {
    if (!first_) return;
    try {
      std::rethrow_exception(std::exchange(first_, nullptr));
    } catch (const pybind11::error_already_set& error) {  // which Python may have had before, and takes only once
      PyErr_Restore(error.type().inc_ref().ptr(), error.value().inc_ref().ptr(), error.trace().inc_ref().ptr());
    }
    throw pybind11::error_already_set();
  }
  /// The run is over: whoever calls a function now hears of its exceptions himself, and has no time budget.
  void end() {
    over_ = true;
    deadline_ = {};
  }

  /// When the time budget of the run ends. Before its search begins.
  void set_deadline(const Deadline& deadline) { deadline_ = deadline; }
  const Deadline& deadline() const { return deadline_; }

  /// A cost that was made for this run, and is part of nothing else.
  void add(std::weak_ptr<const PythonCost> cost) { costs_.push_back(std::move(cost)); }
  const std::vector<std::weak_ptr<const PythonCost>>& costs() const { return costs_; }

 private:
  static PyObject* value_of(const std::exception_ptr& exception) {
    try {
      if (exception) std::rethrow_exception(exception);
    } catch (const pybind11::error_already_set& error) {
      return error.value().ptr();
    } catch (...) {
      return nullptr;
    }
    return nullptr;
  }
  bool is_first(const std::exception_ptr& exception) const {
    const PyObject* value = value_of(exception);
    return value != nullptr && value == value_of(first_);
  }

  std::atomic<bool> any_ = false, over_ = false;
  std::exception_ptr first_;  // guarded by the GIL
  std::vector<std::weak_ptr<const PythonCost>> costs_;
  Deadline deadline_;
};

/// Of options that are read in this thread meanwhile: where what their functions raise goes to.
class ErrorsOfThread {
 public:
  explicit ErrorsOfThread(std::shared_ptr<CallErrors> errors) : before_(std::exchange(current(), std::move(errors))) {}
  ~ErrorsOfThread() { current() = std::move(before_); }
  ErrorsOfThread(const ErrorsOfThread&) = delete;
  ErrorsOfThread& operator=(const ErrorsOfThread&) = delete;

  /// Those of the run that is being read; else new ones, which keep nothing: the cells of a study hear of exceptions
  /// themselves.
  static std::shared_ptr<CallErrors> now() {
    if (current() != nullptr) return current();
    auto none = std::make_shared<CallErrors>();
    none->end();
    return none;
  }

 private:
  static std::shared_ptr<CallErrors>& current() {
    thread_local std::shared_ptr<CallErrors> errors;
    return errors;
  }

  std::shared_ptr<CallErrors> before_;
};

}  // namespace leastcost::python
