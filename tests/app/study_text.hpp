// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "app/study/grid/grid.hpp"
#include "app/study/rows/run_table.hpp"
#include "app/study/study.hpp"
#include "catalogue/output/csv_text.hpp"

namespace leastcost::test {

/// A study of two small problems; tests add to it or break it.
inline const std::string kStudy = R"(problems:
  - name: line
    config:
      manifold: {type: euclidean, dimension: 2}
      cost: euclidean
      ends: {source: {point: [0, 0]}, target: {point: [3, 4]}}
    optimum: 5
  - name: chute
    config:
      manifold: {type: euclidean, dimension: 2}
      cost: {type: travel_time, gravity: 1}
      ends: {source: {point: [0, 0]}, target: {point: [3, -2]}}
solvers: [newton, lbfgs]
points: [8, 12]
)";

inline app::StudyGrid grid_of(const std::string& text, std::string& errors) {
  app::LoadedStudy study = app::parse_study(text, "a.yaml", ".");
  app::StudyGrid grid = app::make_grid(study);
  errors = study.errors.render();
  return grid;
}

inline std::string study_errors(const std::string& text) {
  std::string errors;
  grid_of(text, errors);
  return errors;
}

inline std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// What may not differ between two runs of one study: runs.csv and traces.csv without their times.
inline std::string results_without_times(const std::filesystem::path& folder) {
  app::RunTable table = app::read_runs_csv(content(folder / "runs.csv"), "runs.csv");
  for (app::RunRow& row : table.rows)
    app::visit_time_columns(row, [](const char*, std::optional<double>& seconds) { seconds.reset(); });
  std::vector<app::TraceRow> traces = app::read_traces_csv(content(folder / "traces.csv"), "traces.csv");
  for (app::TraceRow& line : traces) line.seconds = 0;
  return app::runs_csv(table) + app::traces_csv(traces);
}

}  // namespace leastcost::test
