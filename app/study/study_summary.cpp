// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/study_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "app/study/grid/study_config.hpp"
#include "catalogue/output/json_numbers.hpp"

namespace leastcost::app {
namespace {

using Json = nlohmann::ordered_json;

long total(const std::map<std::string, long>& counts) {
  long sum = 0;
  for (const auto& [name, count] : counts) sum += count;
  return sum;
}

long count_of(const std::map<std::string, long>& counts, const std::string& name) {
  const auto it = counts.find(name);
  return it == counts.end() ? 0 : it->second;
}

std::vector<std::pair<long, long>> missing_of(const JournalContent& journal) {
  std::set<std::pair<long, long>> done;
  std::set<long> skipped;
  for (const CellResult& r : journal.results) done.insert({r.row.cell, r.row.repetition});
  for (const SkippedCell& s : journal.facts.skipped) skipped.insert(s.cell);
  std::vector<std::pair<long, long>> missing;
  for (long cell = 0; cell < journal.facts.cells; ++cell) {
    if (!journal.shard.has(cell) || skipped.count(cell) > 0) continue;
    for (long repetition = 0; repetition < journal.facts.repetitions; ++repetition)
      if (done.count({cell, repetition}) == 0) missing.emplace_back(cell, repetition);
  }
  return missing;
}

Json to_json(const Spread& spread) {
  if (spread.count == 0) return nullptr;
  return {{"median", number(spread.median)}, {"min", number(spread.least)}, {"max", number(spread.greatest)}};
}

/// Spread of one column over some rows.
template <class T>
Spread spread_over(const std::vector<const RunRow*>& rows, std::optional<T> RunRow::*column) {
  std::vector<double> values;
  for (const RunRow* row : rows)
    if (row->*column) values.push_back(static_cast<double>(*(row->*column)));
  return spread_of(std::move(values));
}

Json cell_json(const std::vector<const RunRow*>& rows, const std::vector<std::string>& swept_keys) {
  const RunRow& first = *rows.front();
  Json out = {{"cell", first.cell}, {"problem", first.problem}, {"solver", first.solver}, {"kernel", first.kernel}};
  out["points"] = first.points ? Json(*first.points) : Json(nullptr);
  out["seed"] = first.seed ? Json(*first.seed) : Json(nullptr);
  for (std::size_t k = 0; k < swept_keys.size(); ++k) out[swept_keys[k]] = first.swept[k];
  std::map<std::string, long> outcomes, statuses, terminations;
  for (const RunRow* row : rows) {
    ++outcomes[row->outcome];
    if (!row->status.empty()) ++statuses[row->status];
    if (!row->termination.empty()) ++terminations[row->termination];
  }
  out["outcomes"] = outcomes;
  out["statuses"] = statuses;
  out["terminations"] = terminations;
  out["cost"] = to_json(spread_over(rows, &RunRow::cost));
  out["optimum_error"] = to_json(spread_over(rows, &RunRow::optimum_error));
  out["solver_error"] = to_json(spread_over(rows, &RunRow::solver_error));
  out["final_energy"] = to_json(spread_over(rows, &RunRow::final_energy));
  out["iterations"] = to_json(spread_over(rows, &RunRow::iterations));
  out["evaluations"] = to_json(spread_over(rows, &RunRow::evaluations));
  out["s_solve"] = to_json(spread_over(rows, &RunRow::s_solve));
  return out;
}

Json solver_json(const SolverCount& s) {
  return {{"solver", s.solver},
          {"runs", s.runs()},
          {"refused", s.refused()},
          {"failed", s.failed()},
          {"outcomes", s.outcomes},
          {"statuses", s.statuses},
          {"s_solve", to_json(s.seconds)},
          {"evaluations", to_json(s.evaluations)}};
}

Json skipped_json(const StudyFacts& facts) {
  Json out = Json::array();
  std::vector<std::string> axes = standing_axes();
  axes.insert(axes.end(), facts.swept_keys.begin(), facts.swept_keys.end());
  for (const SkippedCell& s : facts.skipped) {
    Json item = {{"cell", s.cell}, {"reason", s.reason}};
    for (std::size_t k = 0; k < axes.size() && k < s.values.size(); ++k) item[axes[k]] = s.values[k];
    out.push_back(std::move(item));
  }
  return out;
}

}  // namespace

long SolverCount::runs() const { return total(outcomes); }
long SolverCount::refused() const { return count_of(outcomes, outcome::kCannotSolve); }
long SolverCount::failed() const { return runs() - refused() - count_of(outcomes, outcome::kOk); }

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return {values.size(), median, values.front(), values.back()};
}

StudySummary summarize(const JournalContent& journal) {
  StudySummary summary;
  std::vector<std::string> order;
  std::map<std::string, std::vector<const RunRow*>> by_solver;
  for (const CellResult& r : journal.results) {
    if (by_solver.count(r.row.solver) == 0) order.push_back(r.row.solver);
    by_solver[r.row.solver].push_back(&r.row);
  }
  for (const std::string& solver : order) {
    SolverCount& count = summary.solvers.emplace_back();
    count.solver = solver;
    std::vector<const RunRow*> good;
    for (const RunRow* row : by_solver[solver]) {
      ++count.outcomes[row->outcome];
      if (row->outcome != outcome::kOk) continue;
      ++count.statuses[row->status];
      good.push_back(row);
    }
    count.seconds = spread_over(good, &RunRow::s_solve);
    count.evaluations = spread_over(good, &RunRow::evaluations);
    summary.runs += count.runs();
    summary.failed += count.failed();
  }
  for (const SkippedCell& s : journal.facts.skipped)
    if (journal.shard.has(s.cell)) ++summary.skipped[s.reason];
  summary.missing = missing_of(journal);
  return summary;
}

std::string summary_json(const JournalContent& journal) {
  const StudySummary summary = summarize(journal);
  const StudyFacts& facts = journal.facts;
  Json out = {{"schema_version", kSchemaVersion},
              {"name", facts.name},
              {"configuration", facts.configuration},
              {"cells_in_grid", facts.cells},
              {"repetitions", facts.repetitions},
              {"shard", {journal.shard.index, journal.shard.count}},
              {"runs", summary.runs},
              {"failed", summary.failed}};
  out["solvers"] = Json::array();
  for (const SolverCount& s : summary.solvers) out["solvers"].push_back(solver_json(s));
  out["cells"] = Json::array();
  std::map<long, std::vector<const RunRow*>> cells;
  for (const CellResult& r : journal.results) cells[r.row.cell].push_back(&r.row);
  for (const auto& [cell, rows] : cells) out["cells"].push_back(cell_json(rows, facts.swept_keys));
  out["skipped"] = skipped_json(facts);
  out["missing"] = summary.missing;
  return to_text(out);
}

std::string summary_text(const StudySummary& summary) {
  std::size_t width = 6;
  for (const SolverCount& s : summary.solvers) width = std::max(width, s.solver.size());
  std::string out =
      fmt::format("{:<{}} {:>6} {:>10} {:>12} {:>10} {:>12} {:>8} {:>7} {:>12} {:>10}\n", "solver", width, "runs",
                  "certified", "uncertified", "collapsed", "interrupted", "refused", "failed", "evaluations", "solve");
  for (const SolverCount& s : summary.solvers) {
    out += fmt::format("{:<{}} {:>6} {:>10} {:>12} {:>10} {:>12} {:>8} {:>7}", s.solver, width, s.runs(),
                       count_of(s.statuses, "certified"), count_of(s.statuses, "uncertified"),
                       count_of(s.statuses, "collapsed"), count_of(s.statuses, "interrupted"), s.refused(), s.failed());
    if (s.seconds.count > 0) out += fmt::format(" {:>12.6g} {:>8.2g} s", s.evaluations.median, s.seconds.median);
    out += '\n';
  }
  for (const SolverCount& s : summary.solvers)
    for (const auto& [name, count] : s.outcomes)
      if (name != outcome::kOk) out += fmt::format("{}: {} of {}\n", name, count, s.solver);
  for (const auto& [reason, count] : summary.skipped)
    out += fmt::format("skipped: {} cell{}: {}\n", count, count == 1 ? "" : "s", reason);
  constexpr std::size_t kShown = 10;
  for (std::size_t i = 0; i < std::min(kShown, summary.missing.size()); ++i)
    out += fmt::format("missing: cell {}, repetition {}\n", summary.missing[i].first, summary.missing[i].second);
  if (summary.missing.size() > kShown) out += fmt::format("missing: {} more\n", summary.missing.size() - kShown);
  return out;
}

}  // namespace leastcost::app
