// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <leastcost/framework/base/monitor.hpp>
#include "app/cli/streams.hpp"

namespace leastcost::app {

/// Shows how far a run is: a bar on a terminal, elsewhere a plain line per 10 % or 30 s, nothing for runs shorter than
/// a second. Percent of a solve is the way of the predicted cost error from its first value to the tolerance, in
/// digits.
class ProgressPrinter {
 public:
  ProgressPrinter(const Streams& streams, bool quiet) : streams_(streams), quiet_(quiet) {}
  ~ProgressPrinter() { clear(); }
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  void show(const Progress& progress);
  /// A domain that is being made.
  void show_building(double part, std::string_view phase);
  /// Of much work of one kind: what it is, how much is done, and how far that is in words.
  void show_part(std::string_view what, double part, std::string_view words);
  /// Takes the bar away, so that other lines can follow.
  void clear();

 private:
  using Clock = Monitor::Clock;
  int percent(const Iteration& iteration);
  void show_more_points(const MorePoints& more);
  void show_bar(const std::string& line, int percent);
  void show_line(const std::string& line, int percent, bool new_stage, bool has_share);

  Streams streams_;
  bool quiet_;
  Clock::time_point start_ = Clock::now(), last_shown_ = start_;
  Stage stage_ = Stage::initialize;
  double first_error_ = 0;
  int last_percent_ = 0;
  int doubling_ = 0;   ///< of the points that is shown; 0: none is
  std::string phase_;  ///< of what is being made; empty: none is
  bool bar_shown_ = false, line_shown_ = false;
};

}  // namespace leastcost::app
