// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/study/rows/journal.hpp"

namespace leastcost::app {

/// Median, least and greatest of some numbers; how many there were.
struct Spread {
  std::size_t count = 0;
  double median = 0, least = 0, greatest = 0;
};
Spread spread_of(std::vector<double> values);

/// What the repetitions of all cells of one solver came to.
struct SolverCount {
  std::string solver;
  std::map<std::string, long> outcomes;  ///< of all repetitions, by outcome
  std::map<std::string, long> statuses;  ///< of those that are ok
  Spread seconds, evaluations;           ///< of the solves that are ok
  long runs() const;
  long refused() const;  ///< the solver said beforehand that it cannot: an answer
  long failed() const;   ///< neither a path nor such an answer
};

struct StudySummary {
  std::vector<SolverCount> solvers;            ///< in the order of the grid
  std::vector<std::pair<long, long>> missing;  ///< cell, repetition: of this shard, neither run nor skipped
  std::map<std::string, long> skipped;         ///< cells by reason
  long runs = 0, failed = 0;
  bool complete_and_ok() const { return failed == 0 && missing.empty(); }
};

/// `results` sorted by cell and repetition.
StudySummary summarize(const JournalContent& journal);

/// summary.json: the counts per solver, and per cell the spread over its repetitions.
std::string summary_json(const JournalContent& journal);
/// A table for people.
std::string summary_text(const StudySummary& summary);

}  // namespace leastcost::app
