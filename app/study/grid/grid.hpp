// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/grid/study_config.hpp"
#include "catalogue/config/run_config.hpp"

namespace leastcost::app {

/// One cell of a study: a run that is ready to be composed.
struct StudyCell {
  long number = 0;                  ///< in the full grid, from 0
  std::vector<std::string> values;  ///< of the axes of the grid: problem, solver, kernel, points, seed, swept keys
  RunConfig config;                 ///< with everything given; not usable where it is skipped for want of its solver
  std::filesystem::path folder;     ///< files of the configuration are relative to it
  std::optional<double> optimum;
  std::string skipped;  ///< why it is left out; empty: it is run
};

/// All cells of a study in their order: the last axis runs fastest. Does not depend on what a machine, a shard or a
/// limit makes of it.
struct StudyGrid {
  std::string name;
  StudyConfig config;
  std::filesystem::path file;
  std::vector<std::filesystem::path> inputs;  ///< configuration files, the study's own first
  std::vector<std::string> swept_keys;
  std::vector<StudyCell> cells;
};

/// How closely every cell is looked at before any of them runs.
enum class CellChecks {
  options,  ///< keys, types, and whether the parts fit each other: quick, nothing is composed
  parts     ///< also what shows only when the parts are made from their options, as in a formula that is not convex
};

/// Makes and checks every cell. Errors of configurations are added to `study.errors` at their place in the study, or
/// with that in the file of the problem; the grid is usable only when there are none.
StudyGrid make_grid(LoadedStudy& study, CellChecks checks = CellChecks::options);

/// make_grid() with `options`. Throws ConfigError.
StudyGrid checked_grid(LoadedStudy study);

/// load_study() and make_grid() with `options`: what only composing a cell shows is its outcome. Throws ConfigError, or
/// InputError when the file cannot be read.
StudyGrid load_grid(const std::filesystem::path& file, const std::vector<Override>& overrides,
                    const Externals& externals = {});

}  // namespace leastcost::app
