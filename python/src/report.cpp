// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What the program makes of the files of a run: its report and its figure. The files are written into a temporary
// folder, so that both are made exactly as by the program.
#include <pybind11/pybind11.h>

#include <filesystem>
#include <span>
#include <string>

#include <leastcost/catalogue/output/write_run.hpp>
#include "app/figure/figure.hpp"
#include "app/report/report.hpp"
#include "catalogue/output/temporary_folder.hpp"
#include "catalogue/scene/scene.hpp"
#include "python/src/bind.hpp"
#include "python/src/outcome.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The content of report.html.
std::string report(const Outcome& result) {
  const RunOutcome& outcome = result.run();
  const py::gil_scoped_release released;
  const TemporaryFolder temporary;
  return make_report(write_run(outcome, temporary.path() / outcome.name)).front().content;
}

/// The picture for a paper, as SVG: width in mm, font size in pt.
std::string figure(const Outcome& result, double width, double font_size) {
  const RunOutcome& outcome = result.run();
  const py::gil_scoped_release released;
  const TemporaryFolder temporary;
  const app::PrintSize size = app::print_size(std::to_string(width) + "mm", std::to_string(font_size));
  return app::make_figure({.folder = write_run(outcome, temporary.path() / outcome.name), .size = size}).svg;
}

/// The content of scene.json.
std::string scene(const Outcome& result) {
  const RunOutcome& outcome = result.run();
  const py::gil_scoped_release released;
  const std::span<const FamilyMember> family(outcome.family);
  return scene_json(make_scene(outcome.parts.problem, outcome.result, family.subspan(family.empty() ? 0 : 1)));
}

}  // namespace

void bind_report(py::module_& module) {
  module.def("report", &report, "outcome"_a);
  module.def("figure", &figure, "outcome"_a, "width"_a, "font_size"_a);
  module.def("scene", &scene, "outcome"_a);
}

}  // namespace leastcost::python
