// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/study_progress.hpp"

#include <fmt/format.h>

#include <ostream>

namespace leastcost::app {
namespace {

constexpr std::chrono::seconds kSilentStudy{1}, kStudyLineInterval{30};

std::string words(const RunRow& row) {
  const std::string points = row.points ? fmt::format(", {} points", *row.points) : "";
  return fmt::format("cell {} ({}, {}, {}{})", row.cell, row.problem, row.solver, row.kernel, points);
}

}  // namespace

void StudyProgressPrinter::show(const StudyProgress& progress) {
  if (quiet_ || progress.row == nullptr) return;
  const RunRow& row = *progress.row;
  if (row.outcome != outcome::kOk) {
    clear();
    streams_.err << fmt::format("{}: {}: {}\n", row.outcome, words(row), row.message) << std::flush;
  }
  const auto now = Clock::now();
  const std::string line = fmt::format("{:8.1f} s  {} of {}  {}", std::chrono::duration<double>(now - start_).count(),
                                       progress.finished, progress.total, words(row));
  if (streams_.err_is_terminal) {
    streams_.err << "\r\033[K" << line << std::flush;
    line_shown_ = true;
    return;
  }
  if (now - start_ < kSilentStudy) return;
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
