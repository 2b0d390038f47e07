// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/pairs/pair_summary.hpp"
#include "app/run/run.hpp"

namespace leastcost::app {

/// How far a run of many pairs is.
struct PairProgress {
  long finished = 0;  ///< earlier calls included
  double part = 0;    ///< of the file of pairs, from 0 to 1
};

struct PairsRequest {
  RunRequest run;
  bool resume = false;  ///< go on where paths.jsonl ends; begin where there is none
  int threads = 1;
  /// Told every line that is new, in order, and whether it was written to paths.jsonl at once, with all before it.
  std::function<void(const std::string& text, bool written)> line = {};
  std::function<void(const PairProgress&)> observe = {};
  std::function<bool()> stop_requested = [] { return false; };
};

struct PairsOutcome {
  PairSummary summary;             ///< of all lines of paths.jsonl
  std::filesystem::path output;    ///< absolute
  std::string unit;                ///< of the costs
  std::vector<std::string> notes;  ///< on how the configuration and its files were read
  long found = 0;                  ///< lines that an earlier call had left
  int threads = 1;
  RunSeconds seconds;        ///< of this call; `search`: all pairs
  bool interrupted = false;  ///< the rest of the pairs is still to be done
};

/// One path for each pair of a configuration with `ends.pairs`, each as a run of its own finds it, in a domain that is
/// made once. Writes manifest.json, config.resolved.yaml, paths.jsonl as it grows, and at the end result.json. The
/// lines are those of the configuration and its files, whatever the threads and interruptions, but for `seconds`; a
/// time budget makes them those of the machine. Throws InputError, OutputRefused, OutputError.
PairsOutcome run_pairs(const Run& run, const PairsRequest& request);

/// The text of result.json.
std::string result_json(const PairsOutcome& outcome, const std::string& name);

/// What reading all pairs tells, without looking for a path.
struct PairsLook {
  long count = 0, faulty = 0;
  bool by_number = false;   ///< of vertices
  std::string first_fault;  ///< with its line; empty: none
};
PairsLook look_at_pairs(const Run& run);

}  // namespace leastcost::app
