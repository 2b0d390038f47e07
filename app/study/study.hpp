// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/externals.hpp>
#include "app/study/cell/prepare_cell.hpp"
#include "app/study/cell/run_cell.hpp"
#include "app/study/grid/grid.hpp"
#include "app/study/rows/journal.hpp"

namespace leastcost::app {

/// A result as a study counts it, while it runs.
struct StudyProgress {
  std::size_t finished = 0, total = 0;  ///< repetitions of cells of this shard
  std::size_t earlier = 0;              ///< of the finished: those that an interrupted study had left
  const RunRow* row = nullptr;          ///< the last one that finished; null before the first
};

struct StudyRequest {
  std::filesystem::path config_file;
  std::optional<std::string> text = {};  ///< of the study, where it is in memory: config_file is then its name
  std::vector<Override> overrides;
  Externals externals = {};      ///< objects that the study names
  std::filesystem::path output;  ///< empty: results/<name>
  bool force = false;            ///< begin anew in the folder of an earlier study
  bool resume = false;           ///< go on where the journal ends; begin where there is none
  int parallel = 1;              ///< cells at once
  Shard shard;
  std::vector<std::string> arguments;  ///< of the program, for the manifest
  std::function<CellResult(const StudyCell&, long repetition)> run = run_cell;
  std::function<void(const StudyCell&)> prepare = prepare_cell;  ///< before the first of several of one composition
  std::function<void(const StudyProgress&)> observe = {};
  std::function<bool()> stop_requested = {};
  std::function<void()> loaded = {};  ///< told when all files have been read; the folder is there then, and empty
};

struct StudyOutcome {
  JournalContent journal;
  std::filesystem::path output;  ///< absolute
  bool interrupted = false;      ///< what had finished is in the journal; nothing is derived from it
};

/// Where the results of a request go.
std::filesystem::path output_of(const StudyRequest& request, const StudyGrid& grid);

/// Runs the cells of a shard that the journal lacks, each in a process of its own, and writes the files that are
/// derived from the journal. Keys and types of all cells are checked first, then the folder; a cell is composed when
/// its turn comes, and what is wrong then is its outcome. Results depend on the study alone, not on `parallel`, shards
/// or interruptions; times do. Throws ConfigError, InputError, OutputRefused, OutputError.
StudyOutcome run_study(const StudyRequest& request);

}  // namespace leastcost::app
