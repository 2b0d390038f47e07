// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/run/compose.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/python_cost.hpp"
#include "python/src/signals.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// A configuration as _config.py hands it over: its text, what messages call it, what its files are relative to.
struct Source {
  std::optional<std::filesystem::path> file;  ///< read from here; none: `text`
  std::string text, name;
  std::filesystem::path folder;
  std::vector<std::string> assignments;

  std::vector<Override> overrides() const {
    std::vector<Override> list;
    for (const std::string& assignment : assignments) list.push_back({assignment, "set: " + assignment});
    return list;
  }
};

Run read(const Source& source, Signals& signals) {
  const BuildProgress progress = [&](double, std::string_view) {
    if (signals.stop()) throw StoppedEarly("interrupted before a path was found");
  };
  if (source.file) return load_run(*source.file, source.overrides(), progress);
  return parse_run(source.text, source.name, source.folder, source.overrides(), progress);
}

/// Without the GIL. Of an interrupted search the best path so far, if there is one. `cost`, unless null, takes the
/// place of that of the configuration; what it raises is raised here.
RunOutcome run(const Source& source, std::optional<double> max_seconds, const std::shared_ptr<PythonCost>& cost) {
  Signals signals;
  std::optional<RunOutcome> outcome;
  try {
    const py::gil_scoped_release released;
    Run run = read(source, signals);
    if (max_seconds) run.max_seconds = max_seconds;
    if (cost) run.parts.problem.cost = cost;
    Monitor monitor;
    monitor.stop_requested = [&] { return signals.stop() || (cost && cost->failed()); };
    outcome.emplace(solve(std::move(run), monitor));
  } catch (const std::exception&) {
    signals.raise();
    if (cost) cost->raise();
    throw;
  }
  if (cost) cost->raise();
  if (outcome->result.status == Status::interrupted && outcome->result.path.u.cols() > 0)
    signals.deliver();
  else
    signals.raise();
  return std::move(*outcome);
}

/// Every error of a configuration, those of the parts it names included, without making its domain.
void validate(const Source& source) {
  const py::gil_scoped_release released;
  LoadedConfig loaded = source.file ? load_config(*source.file, source.overrides())
                                    : parse_config(source.text, source.name, source.folder, source.overrides());
  if (loaded.errors.empty()) check_parts(loaded);
  if (!loaded.errors.empty()) throw ConfigError(loaded.errors);
}

}  // namespace

void bind_run(py::module_& module) {
  py::class_<Source>(module, "Source")
      .def(
          py::init([](std::optional<std::filesystem::path> file, std::string text, std::string name,
                      std::filesystem::path folder, std::vector<std::string> assignments) {
            return Source{std::move(file), std::move(text), std::move(name), std::move(folder), std::move(assignments)};
          }),
          "file"_a, "text"_a, "name"_a, "folder"_a, "assignments"_a);
  py::class_<RunOutcome>(module, "Outcome")
      .def("points", [](const RunOutcome& o) { return rows_of(o.result.path.u); })
      .def("curve", [](const RunOutcome& o) { return rows_of(o.result.curve.x); })
      .def("json", &result_json)
      .def(
          "write",
          [](const RunOutcome& o, const std::filesystem::path& folder, bool replace) {
            const py::gil_scoped_release released;
            return write_run(o, folder, {.replace = replace});
          },
          "folder"_a, "replace"_a);
  py::class_<PythonCost, std::shared_ptr<PythonCost>>(module, "Cost")
      .def(py::init([](py::function q, int dim, std::string unit, bool symmetric, bool additive) {
             CostTraits traits{.unit = std::move(unit), .symmetric = symmetric, .additive = additive};
             return std::make_shared<PythonCost>(std::move(q), dim, std::move(traits));
           }),
           "q"_a, "dim"_a, "unit"_a, "symmetric"_a, "additive"_a);
  module.def("run", &run, "source"_a, "max_seconds"_a, "cost"_a);
  module.def("validate", &validate, "source"_a);
}

}  // namespace leastcost::python
