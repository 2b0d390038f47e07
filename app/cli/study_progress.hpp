// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "app/cli/streams.hpp"
#include "app/study/study.hpp"

namespace leastcost::app {

/// Shows how far a study is: one changing line on a terminal, elsewhere a plain line per 10 % or 30 s, nothing for
/// studies shorter than a second. A cell that failed gets a line of its own.
class StudyProgressPrinter {
 public:
  StudyProgressPrinter(const Streams& streams, bool quiet) : streams_(streams), quiet_(quiet) {}
  ~StudyProgressPrinter() { clear(); }
  StudyProgressPrinter(const StudyProgressPrinter&) = delete;
  StudyProgressPrinter& operator=(const StudyProgressPrinter&) = delete;

  void show(const StudyProgress& progress);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  Streams streams_;
  bool quiet_;
  Clock::time_point start_ = Clock::now(), last_shown_ = start_;
  std::size_t last_tenth_ = 0;
  bool line_shown_ = false;
};

}  // namespace leastcost::app
