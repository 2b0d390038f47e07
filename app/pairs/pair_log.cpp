// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/pairs/pair_log.hpp"

#include <fmt/format.h>

#include <fstream>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::app {
namespace {

constexpr std::size_t kMostAside = 1 << 16;  // bytes
constexpr std::chrono::milliseconds kLongestAside{200};

/// How many bytes of a log are whole lines; what they say is added to the summary.
std::size_t whole_lines_of(const std::filesystem::path& file, PairSummary& summary) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": cannot be opened");
  std::size_t size = 0;
  for (std::string line; std::getline(in, line) && !in.eof();) {
    const auto wrong = [&](const std::string& what) {
      throw InputError(fmt::format("{}:{}: {}", file.string(), summary.count + 1, what));
    };
    try {
      const PairFacts facts = read_pair_line(line);
      if (facts.number != summary.count) wrong(fmt::format("is of pair {}, not {}", facts.number, summary.count));
      summary.add(facts);
    } catch (const InputError& e) {
      wrong(e.what());
    }
    size += line.size() + 1;
  }
  return size;
}

}  // namespace

PairLog::PairLog(const std::filesystem::path& file, bool keep, PairSummary& summary) : file_(file, "these results") {
  file_.cut(keep ? whole_lines_of(file, summary) : 0);
}

bool PairLog::append(const std::string& line) {
  aside_ += line;
  if (aside_.size() < kMostAside && Clock::now() - flushed_ < kLongestAside) return false;
  flush();
  return true;
}

void PairLog::flush() {
  if (!aside_.empty()) file_.append(aside_);
  aside_.clear();
  flushed_ = Clock::now();
}

void PairLog::finish() {
  flush();
  file_.sync();
}

}  // namespace leastcost::app
