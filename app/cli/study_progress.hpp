// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "app/cli/streams.hpp"
#include "app/study/study.hpp"

namespace leastcost::app {

/// How long the rest takes if it goes on as it has: "about 3 min left"; empty before the first result and after the
/// last.
std::string time_left(const StudyProgress& progress, double seconds);

/// Shows how far a study is and how long the rest takes: one changing line on a terminal, elsewhere a plain line per 10
/// % or 30 s, nothing for studies shorter than a second. A cell that failed gets a line of its own.
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
