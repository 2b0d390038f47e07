// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/study_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace leastcost::app {
namespace {

constexpr std::chrono::seconds kSilentStudy{1}, kStudyLineInterval{30};

std::string words(const RunRow& row) {
  const std::string points = row.points ? fmt::format(", {} points", *row.points) : "";
  return fmt::format("cell {} ({}, {}, {}{})", row.cell, row.problem, row.solver, row.kernel, points);
}

}  // namespace

std::string time_left(const StudyProgress& progress, double seconds) {
  if (progress.finished <= progress.earlier || progress.finished >= progress.total) return "";
  const double each = seconds / static_cast<double>(progress.finished - progress.earlier);
  const double left = each * static_cast<double>(progress.total - progress.finished);
  constexpr double kMinute = 60, kHour = 3600, kFewUnits = 2;  // 90 s say more than 2 min
  if (left < kFewUnits * kMinute) return fmt::format("about {:.0f} s left", std::max(1.0, left));
  if (left < kFewUnits * kHour) return fmt::format("about {:.0f} min left", left / kMinute);
  return fmt::format("about {:.0f} h left", left / kHour);
}

void StudyProgressPrinter::show(const StudyProgress& progress) {
  if (quiet_) return;
  const RunRow* row = progress.row;
  if (row != nullptr && row->outcome != outcome::kOk) {
    clear();
    streams_.err << fmt::format("{}: {}: {}\n", row->outcome, words(*row), row->message) << std::flush;
  }
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string left = time_left(progress, seconds);
  const std::string line =
      fmt::format("{:8.1f} s  {} of {}{}{}{}{}", seconds, progress.finished, progress.total, left.empty() ? "" : ", ",
                  left, row == nullptr ? "" : "  ", row == nullptr ? "" : words(*row));
  if (streams_.err_is_terminal) {
    streams_.err << "\r\033[K" << line << std::flush;
    line_shown_ = true;
    return;
  }
  if (row == nullptr || now - start_ < kSilentStudy) return;
  const std::size_t tenth = 10 * progress.finished / progress.total;
  if (tenth == last_tenth_ && now - last_shown_ < kStudyLineInterval) return;
  last_tenth_ = tenth;
  last_shown_ = now;
  streams_.err << line << '\n' << std::flush;
}

void StudyProgressPrinter::clear() {
  if (line_shown_) streams_.err << "\r\033[K" << std::flush;
  line_shown_ = false;
}

}  // namespace leastcost::app
