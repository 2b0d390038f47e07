// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/externals.hpp>
#include <leastcost/catalogue/yaml/diagnostics.hpp>
#include <leastcost/catalogue/yaml/override.hpp>

namespace leastcost {

/// How a study is run, and who hears of it.
struct StudyOptions {
  std::filesystem::path output = {};  ///< folder of the results; empty: that of its name in results/
  bool replace = false;               ///< begin anew in the folder of an earlier study
  bool resume = false;                ///< go on where its journal ends; begin where there is none
  int parallel = 1;                   ///< cells at once, each a process of its own
  int shard = 0, shards = 1;          ///< the cells whose number leaves the remainder `shard`
  /// Told how many repetitions of cells have finished, at first and after each.
  std::function<void(std::size_t finished, std::size_t total)> observe = {};
  std::function<bool()> stop_requested = {};  ///< asked between cells; true: the study ends, and can be resumed
  std::vector<std::string> arguments = {};    ///< how the program was called, for manifest.json
};

/// What became of a study; all of it is in its folder: runs.csv, traces.csv, summary.json, manifest.json.
struct StudyResult {
  std::filesystem::path folder;  ///< absolute
  long runs = 0;                 ///< repetitions of cells that have ended, earlier calls included
  long failed = 0;               ///< of these: without a path, and not refused by the solver either
  std::size_t missing = 0;       ///< of this shard: neither run nor skipped
  bool interrupted = false;      ///< stopped: the journal has what had finished, the other files are not there yet
  std::string summary;           ///< the text of summary.json

  /// Whether every cell ran and ended well.
  bool complete_and_ok() const { return !interrupted && failed == 0 && missing == 0; }
};

/// Runs the cells of a study (of a shard of it), each in a forked process of its own, and writes the files of results;
/// write_report() makes the page of them. Plug-ins that the program has registered are in the cells, too. Fork copies
/// the thread that calls: call it while there is no other one. Throws ConfigError with every error and its place,
/// InputError, OutputRefused, OutputError.
///
/// `externals`: objects that problems, solvers and kernels name as {type: external, name: ..}, as of load_run(). Each
/// cell has what a fork copies of them. They are no part of what tells one study from another: who resumes one hands
/// over the same.
StudyResult run_study(const std::filesystem::path& file, const std::vector<Override>& overrides = {},
                      const StudyOptions& options = {}, const Externals& externals = {});

/// The same for a study that is in memory. `name`: what messages call it, and the default name of the study; `folder`:
/// what its files are relative to, empty for the current one.
StudyResult run_study_text(std::string text, const std::string& name, const std::filesystem::path& folder = {},
                           const std::vector<Override>& overrides = {}, const StudyOptions& options = {},
                           const Externals& externals = {});

}  // namespace leastcost
