// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/app/report.hpp>
#include <leastcost/app/study.hpp>
#include "app/study/grid/grid.hpp"
#include "python/src/bind.hpp"
#include "python/src/fork.hpp"
#include "python/src/signals.hpp"
#include "python/src/source.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr const char* kStudyName = "study";  // of what has no file

/// The folder of the results. `file`: none for `text`.
std::filesystem::path study(const std::optional<std::filesystem::path>& file, const std::string& text,
                            const std::filesystem::path& folder, const std::vector<std::string>& assignments,
                            const std::filesystem::path& output, bool replace, bool resume, int parallel,
                            const std::map<std::string, External>& externals) {
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
    const auto errors = std::make_shared<CallErrors>();
    errors->end();  // cells hear of exceptions themselves
    const Externals made = objects_of(externals, errors, [&](const Externals& all) {
      app::LoadedStudy study = file ? app::load_study(*file, overrides, all)
                                    : app::parse_study(text, (folder / kStudyName).string(), folder, overrides, all);
      const app::StudyGrid grid = app::make_grid(study);
      return grid.cells.empty() ? kAnyDimension : dimension_of(grid.cells.front().config, grid.cells.front().folder);
    });
    result = file ? run_study(*file, overrides, options, made)
                  : run_study_text(text, kStudyName, folder, overrides, options, made);
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
             "parallel"_a, "externals"_a);
  module.def("write_report", &write_report, "folder"_a, py::call_guard<py::gil_scoped_release>());
}

}  // namespace leastcost::python
