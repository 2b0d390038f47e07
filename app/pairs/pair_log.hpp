// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "app/pairs/pair_summary.hpp"
#include "app/study/rows/locked_file.hpp"

namespace leastcost::app {

/// paths.jsonl while it grows. Lines are written some at a time, so that a kill takes away what a fifth of a second
/// brought, and perhaps leaves a torn last one.
class PairLog {
 public:
  /// Opens the file, emptied unless its lines are to be kept: `summary` is then what they say, and a torn last line is
  /// cut off. Throws OutputRefused where another process writes to it, InputError where it holds anything else than
  /// lines of the pairs in their order, OutputError.
  PairLog(const std::filesystem::path& file, bool keep, PairSummary& summary);

  /// True when it was written with all before it, not only put aside.
  bool append(const std::string& line);
  /// Writes what was put aside, and waits until it is on the disk.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void flush();

  LockedFile file_;
  std::string aside_;
  Clock::time_point flushed_ = Clock::now();
};

}  // namespace leastcost::app
