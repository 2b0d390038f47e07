// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/catalogue/plugins/externals.hpp>
#include "catalogue/plugins/run_visitor.hpp"
#include "catalogue/yaml/config_node.hpp"
#include "catalogue/yaml/overrides.hpp"

namespace leastcost::app {

/// One problem of a study.
struct StudyProblem {
  std::optional<std::string> name;  ///< else that of its configuration
  ConfigNode config;                ///< a file name, or a configuration
  std::optional<double> optimum;    ///< true least cost
  ConfigNode set;                   ///< options of this problem only
  bool optional = false;            ///< its cells are skipped where a file of it does not exist
  void fields(RunVisitor& visit);
};

/// Cells that are left out: all whose values are among those given, on every axis that is.
struct StudySkip {
  std::map<std::string, std::vector<std::string>> values;  ///< by axis
  std::string because;
};

/// A study as its file describes it. What goes into the configurations of its runs is kept as trees: the reader of
/// configurations checks it, at its place in this file, when the cells are made (app/study/grid).
struct StudyConfig {
  std::string name;  ///< default: the name of the file
  int seed = 0;
  std::vector<StudyProblem> problems;
  ConfigNode solvers, kernels, points, seeds, sweep, set;
  std::vector<StudySkip> skip;
  int repetitions = 1;
  std::optional<double> max_seconds;   ///< of one repetition of one cell
  double grace_seconds = 10;           ///< after them its process is killed
  std::optional<int> max_evaluations;  ///< else those of the solvers
  std::optional<int> max_memory;       ///< MB of address space

  void fields(RunVisitor& visit);
};

/// A study file after reading.
struct LoadedStudy {
  std::filesystem::path file, folder;
  std::string text;
  ConfigNode tree;  ///< overrides included
  StudyConfig config;
  Diagnostics errors;
  Externals externals = {};  ///< objects that it may name
};

/// The standing axes, in the order of the grid: problem, solver, kernel, points, seed.
const std::vector<std::string>& standing_axes();

/// Whether a configuration text describes a study: it has a top-level key `problems`.
bool is_study(const std::string& text);

/// Reads and checks the study file itself; the cells are not made yet. Throws InputError when it cannot be read.
LoadedStudy load_study(const std::filesystem::path& file, const std::vector<Override>& overrides,
                       const Externals& externals = {});
LoadedStudy parse_study(std::string text, const std::string& file_name, const std::filesystem::path& folder,
                        const std::vector<Override>& overrides = {}, const Externals& externals = {});

}  // namespace leastcost::app
