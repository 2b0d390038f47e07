// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/app/report.hpp>
#include <leastcost/app/study.hpp>
#include "python/src/bind.hpp"
#include "python/src/fork.hpp"
#include "python/src/signals.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The folder of the results. `file`: none for `text`.
std::filesystem::path study(const std::optional<std::filesystem::path>& file, const std::string& text,
                            const std::filesystem::path& folder, const std::vector<std::string>& assignments,
                            const std::filesystem::path& output, bool replace, bool resume, int parallel) {
  const ForksPython forks;
  Signals signals;
  StudyResult result;
  try {
    const py::gil_scoped_release released;
    std::vector<Override> overrides;
    for (const std::string& assignment : assignments) overrides.push_back({assignment, "set: " + assignment});
    const StudyOptions options{
        .output = output, .replace = replace, .resume = resume, .parallel = parallel, .stop_requested = [&] {
          return signals.stop();
        }};
    result = file ? run_study(*file, overrides, options) : run_study_text(text, "study", folder, overrides, options);
  } catch (const std::exception&) {
    signals.raise();
    throw;
  }
  signals.raise();
  return result.folder;
}

}  // namespace

void bind_study(py::module_& module) {
  module.def("study", &study, "file"_a, "text"_a, "folder"_a, "assignments"_a, "output"_a, "replace"_a, "resume"_a,
             "parallel"_a);
  module.def("write_report", &write_report, "folder"_a, py::call_guard<py::gil_scoped_release>());
}

}  // namespace leastcost::python
