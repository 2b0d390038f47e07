// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace leastcost::app {
namespace {

constexpr double kTolerance = 1e-14;  // of the solvers, relative cost error: where 100 % is
constexpr std::chrono::milliseconds kBarInterval{100};
constexpr std::chrono::seconds kSilentStart{1}, kLineInterval{30};

}  // namespace

int ProgressPrinter::percent(const Iteration& iteration) {
  const double error = iteration.cost_error;
  if (!(error > 0) || !std::isfinite(error)) return 0;
  if (first_error_ <= kTolerance) first_error_ = error;
  const double whole = std::log(first_error_ / kTolerance);
  if (!(whole > 0)) return 0;
  return std::clamp(static_cast<int>(100 * std::log(first_error_ / error) / whole), 0, 100);
}

void ProgressPrinter::show(const Progress& progress) {
  if (quiet_) return;
  if (progress.more_points != nullptr) return show_more_points(*progress.more_points);
  doubling_ = 0;
  const bool new_stage = progress.stage != stage_ || progress.iteration == nullptr;
  if (new_stage) {
    stage_ = progress.stage;
    first_error_ = 0;
    last_percent_ = 0;
  }
  std::string line = fmt::format("{:<12}", word_of(stage_));
  int done = 0;
  if (const Iteration* i = progress.iteration) {
    done = percent(*i);
    line += fmt::format(" iteration {}, ", i->iteration);
    line += std::isfinite(i->cost_error) ? fmt::format("cost error {:.1e}", i->cost_error)
                                         : fmt::format("energy {:.10g}", i->energy);
  }
  if (streams_.err_is_terminal)
    show_bar(line, done);
  else
    show_line(line, done, new_stage, stage_ == Stage::solve);
}

/// The stages of such a search come and go too fast to be told apart.
void ProgressPrinter::show_more_points(const MorePoints& more) {
  const bool new_doubling = more.doubling != doubling_;
  doubling_ = more.doubling;
  const std::string line = fmt::format("certificate: trying {} points ({} of {})", more.points, more.doubling, more.of);
  const int done = 100 * (more.doubling - 1) / std::max(1, more.of);
  if (streams_.err_is_terminal)
    show_bar(line, done);
  else
    show_line(line, done, new_doubling, false);
}

void ProgressPrinter::show_building(double part, std::string_view phase) {
  if (quiet_) return;
  const bool new_phase = phase != phase_;
  if (new_phase) {
    phase_ = phase;
    last_percent_ = 0;
  }
  const int done = std::clamp(static_cast<int>(100 * part), 0, 100);
  const std::string line = fmt::format("{:<12} {}", "build", phase);
  if (streams_.err_is_terminal)
    show_bar(line, done);
  else if (Clock::now() - last_shown_ >= kSilentStart)
    show_line(line, done, new_phase, true);
}

void ProgressPrinter::show_part(std::string_view what, double part, std::string_view words) {
  if (quiet_) return;
  if (streams_.err_is_terminal ? Clock::now() - last_shown_ < kBarInterval : Clock::now() - start_ < kSilentStart)
    return;  // may be asked for every millisecond
  const int done = std::clamp(static_cast<int>(100 * part), 0, 100);
  const std::string line = fmt::format("{:<12} {}", what, words);
  if (streams_.err_is_terminal)
    show_bar(line, done);
  else
    show_line(line, done, false, true);
}

void ProgressPrinter::show_bar(const std::string& line, int percent) {
  const auto now = Clock::now();
  if (now - last_shown_ < kBarInterval) return;
  last_shown_ = now;
  constexpr int kWidth = 20;
  const int full = percent * kWidth / 100;
  streams_.err << fmt::format("\r\033[K[{:#<{}}{:.<{}}] {}", "", full, "", kWidth - full, line) << std::flush;
  bar_shown_ = true;
}

void ProgressPrinter::show_line(const std::string& line, int percent, bool new_stage, bool has_share) {
  const auto now = Clock::now();
  if (now - start_ < kSilentStart) return;
  const bool due = new_stage || !line_shown_ || percent >= last_percent_ + 10 || now - last_shown_ >= kLineInterval;
  if (!due) return;
  line_shown_ = true;
  last_shown_ = now;
  last_percent_ = percent - percent % 10;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string share = has_share ? fmt::format("{:3d} %", percent) : "     ";
  streams_.err << fmt::format("{:8.1f} s  {}  {}\n", seconds, share, line) << std::flush;
}

void ProgressPrinter::clear() {
  if (bar_shown_) streams_.err << "\r\033[K" << std::flush;
  bar_shown_ = false;
}

}  // namespace leastcost::app
