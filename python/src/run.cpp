// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/outcome.hpp"
#include "python/src/signals.hpp"
#include "python/src/source.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// Of an interrupted search the best path so far, if there is one. What functions of the configuration raise is raised
/// here.
Outcome run(const Source& source, std::optional<double> max_seconds) {
  Signals signals;
  const auto errors = std::make_shared<CallErrors>();
  std::optional<RunOutcome> outcome;
  try {
    const py::gil_scoped_release released;
    const BuildProgress progress = [&](double, std::string_view) {
      if (signals.stop()) throw StoppedEarly("interrupted before a path was found");
    };
    Run run = source.read(progress, errors);
    if (max_seconds) run.max_seconds = max_seconds;
    if (run.max_seconds)
      errors->set_deadline(Monitor::Clock::now() + std::chrono::duration_cast<Monitor::Clock::duration>(
                                                       std::chrono::duration<double>(*run.max_seconds)));
    Monitor monitor;
    monitor.stop_requested = [&] { return signals.stop() || errors->any(); };
    outcome.emplace(solve(std::move(run), monitor));
  } catch (const std::exception&) {
    signals.raise();
    errors->raise();
    throw;
  }
  errors->raise();
  errors->end();
  if (outcome->result.status == Status::interrupted && outcome->result.path.u.cols() > 0)
    signals.deliver();
  else
    signals.raise();
  return Outcome(std::move(*outcome), errors);
}

/// The result in an object of Python; null while it is being made.
const Outcome* outcome_in(PyObject* self) {
  auto* instance = reinterpret_cast<py::detail::instance*>(self);
  const py::detail::value_and_holder held = instance->get_value_and_holder();
  return held.holder_constructed() ? held.value_ptr<Outcome>() : nullptr;
}

/// Lets Python's garbage collector see through a result to the functions that its cost is made of.
void collect_cycles(PyHeapTypeObject* heap_type) {
  PyTypeObject& type = heap_type->ht_type;
  type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) {
    Py_VISIT(Py_TYPE(self));
    const Outcome* outcome = outcome_in(self);
    return outcome == nullptr ? 0 : outcome->traverse(visit, arg);
  };
  type.tp_clear = [](PyObject* self) {
    if (const Outcome* outcome = outcome_in(self)) outcome->clear();
    return 0;
  };
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<Source>(module, "Source")
      .def(py::init([](std::optional<std::filesystem::path> file, std::string text, const std::optional<py::dict>& tree,
                       std::filesystem::path folder, std::vector<std::string> assignments,
                       std::map<std::string, External> externals) {
             return Source{std::move(file),        tree ? std::optional(block_of(*tree)) : std::nullopt,
                           std::move(text),        std::move(folder),
                           std::move(assignments), std::move(externals)};
           }),
           "file"_a, "text"_a, "tree"_a, "folder"_a, "assignments"_a, "externals"_a);
  py::class_<Outcome>(module, "Outcome", py::custom_type_setup(collect_cycles))
      .def("points", &Outcome::points)
      .def("curve", &Outcome::curve)
      .def("json", &Outcome::json)
      .def(
          "trajectory",
          [](const Outcome& outcome, const std::optional<Numbers>& velocity, const std::optional<Numbers>& acceleration,
             const std::optional<std::filesystem::path>& limits, double interval) {
            const auto vector_of = [](const std::optional<Numbers>& given) -> std::optional<Eigen::VectorXd> {
              if (!given) return std::nullopt;
              return Eigen::Map<const Eigen::VectorXd>(given->data(), given->size());
            };
            return outcome.trajectory(vector_of(velocity), vector_of(acceleration), limits, interval);
          },
          "velocity"_a, "acceleration"_a, "limits"_a, "interval"_a)
      .def("write", &Outcome::write, "folder"_a, "replace"_a)
      .def(py::pickle([](const Outcome& outcome) { return outcome.state(); },
                      [](py::tuple state) { return Outcome(std::move(state)); }));
  module.def("run", &run, "source"_a, "max_seconds"_a);
  module.def("validate", &Source::validate, "source"_a, py::call_guard<py::gil_scoped_release>());
}

}  // namespace leastcost::python
