// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/study_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace leastcost::app {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A certified chain whose relative cost excess is larger is another minimum: the certificate allows 1e-10 on smooth domains, and 1e-6 on meshes.
constexpr double kSameMinimum = 1e-5;

double or_nan(const std::optional<double>& value) { return value.value_or(std::nan("")); }

/// What makes rows comparable, in the order in which it is shown.
std::vector<std::string> key_of(const RunRow& row) {
  std::vector<std::string> key = {row.problem, row.points ? std::to_string(*row.points) : "", row.kernel,
                                  row.seed ? std::to_string(*row.seed) : ""};
  key.insert(key.end(), row.swept.begin(), row.swept.end());
  return key;
}

/// Position of a value in a list that grows by it.
template <class T>
std::size_t place_in(std::vector<T>& list, const T& value) {
  const auto found = std::find(list.begin(), list.end(), value);
  if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
  list.push_back(value);
  return list.size() - 1;
}

using Traces = std::map<std::pair<long, long>, std::vector<const TraceRow*>>;

class Analysis {
 public:
  Analysis(const RunTable& runs, const std::vector<TraceRow>& traces) : runs_(runs) {
    for (const TraceRow& t : traces) traces_[{t.cell, t.repetition}].push_back(&t);
  }

  StudyAnalysis study() {
    std::vector<std::vector<std::string>> keys;
    for (const RunRow& row : runs_.rows) {
      const std::size_t group = place_in(keys, key_of(row)), solver = place_in(out_.solvers, row.solver);
      rows_.resize(std::max(rows_.size(), group + 1));
      rows_[group][solver].push_back(&row);
    }
    const std::vector<char> varies = varying(keys);
    for (std::size_t g = 0; g < keys.size(); ++g) out_.groups.push_back(make_group(g, keys[g], varies));
    return std::move(out_);
  }

 private:
  /// Which parts of the key tell groups of one problem apart. Seeds do only where nothing else does: they follow the cell.
  std::vector<char> varying(const std::vector<std::vector<std::string>>& keys) const {
    std::vector<char> varies(keys.empty() ? 0 : keys[0].size(), 0);
    for (std::size_t k = 1; k < varies.size(); ++k)
      for (std::size_t a = 0; a < keys.size(); ++a) varies[k] = varies[k] != 0 || keys[a][k] != keys[0][k] ? 1 : 0;
    if (!varies.empty()) varies[3] = seeds_matter(keys) ? 1 : 0;
    return varies;
  }

  static bool seeds_matter(const std::vector<std::vector<std::string>>& keys) {
    std::set<std::vector<std::string>> without;
    for (std::vector<std::string> key : keys) {
      key[3].clear();
      if (!without.insert(key).second) return true;
    }
    return false;
  }

  Group make_group(std::size_t g, const std::vector<std::string>& key, const std::vector<char>& varies) {
    Group group;
    group.problem = key[0];
    group.points = key[1].empty() ? 0 : std::stol(key[1]);
    for (std::size_t k = 2; k < key.size(); ++k) {
      if (varies[k] == 0) continue;
      const std::string name = k == 2 ? "" : k == 3 ? "seed " : runs_.swept_keys[k - 4] + " ";
      group.rest += (group.rest.empty() ? "" : ", ") + name + key[k];
    }
    group.label = group.problem + (varies[1] != 0 && !key[1].empty() ? ", n = " + key[1] : "");
    if (!group.rest.empty()) group.label += ", " + group.rest;
    const double best = least_energy(g);
    group.tasks.resize(out_.solvers.size());
    for (const auto& [solver, rows] : rows_[g]) group.tasks[solver] = make_task(rows, best);
    return group;
  }

  /// Of all rows of the group with a path.
  double least_energy(std::size_t g) const {
    double best = kInfinity;
    for (const auto& [solver, rows] : rows_[g])
      for (const RunRow* row : rows)
        if (row->outcome == outcome::kOk && row->final_energy && std::isfinite(*row->final_energy))
          best = std::min(best, *row->final_energy);
    return best;
  }

  static double excess(double energy, double best, const RunRow& row) {
    const double slope = or_nan(row.energy_slope);
    return slope > 0 ? std::max(0.0, energy - best) / slope : std::nan("");
  }

  Task make_task(const std::vector<const RunRow*>& rows, double best) const {
    const RunRow& first = *rows[0];
    Task task;
    std::vector<double> seconds, evaluations;
    for (const RunRow* row : rows) {
      if (row->s_solve) seconds.push_back(*row->s_solve);
      if (row->evaluations) evaluations.push_back(static_cast<double>(*row->evaluations));
      task.repetitions.push_back(descent_of(*row, best));
    }
    task.seconds = spread_of(std::move(seconds));
    task.evaluations = spread_of(std::move(evaluations));
    task.descent = task.repetitions[0];
    task.excess = excess(or_nan(first.final_energy), best, first);
    task.solver_error = or_nan(first.solver_error);
    task.optimum_error = or_nan(first.optimum_error);
    task.bar = or_nan(first.cost_error_bar) / std::abs(or_nan(first.optimum));
    task.chain_error = std::abs(or_nan(first.chain_cost) - or_nan(first.optimum)) / std::abs(or_nan(first.optimum));
    task.verdict = verdict_of(first, task.excess);
    task.reason = reason_of(first, task.verdict);
    return task;
  }

  Descent descent_of(const RunRow& row, double best) const {
    Descent out;
    const auto found = traces_.find({row.cell, row.repetition});
    if (found == traces_.end()) return out;
    for (const TraceRow* t : found->second) {
      out.evaluations.push_back(static_cast<double>(t->evaluations));
      out.seconds.push_back(t->seconds);
      out.excess.push_back(excess(t->energy, best, row));
    }
    return out;
  }

  static Verdict verdict_of(const RunRow& row, double excess) {
    if (row.outcome != outcome::kOk) return Verdict::failed;
    if (row.status != "certified") return Verdict::uncertified;
    return excess > kSameMinimum ? Verdict::other_minimum : Verdict::certified;
  }

  static std::string reason_of(const RunRow& row, Verdict verdict) {
    if (verdict == Verdict::failed) return row.outcome + (row.message.empty() ? "" : ": " + row.message);
    std::string text = verdict == Verdict::other_minimum ? "certified, but another minimum" : row.status;
    text += ", " + row.termination;
    if (!row.failures.empty()) text += ": " + row.failures;
    return row.message.empty() ? text : text + " (" + row.message + ")";
  }

  const RunTable& runs_;
  Traces traces_;
  std::vector<std::map<std::size_t, std::vector<const RunRow*>>> rows_;  // by group and solver
  StudyAnalysis out_;
};

}  // namespace

StudyAnalysis analyse(const RunTable& runs, const std::vector<TraceRow>& traces) {
  StudyAnalysis study = Analysis(runs, traces).study();
  for (Group& group : study.groups) group.tasks.resize(study.solvers.size());
  return study;
}

WorkTable work_table(const StudyAnalysis& study, Work work, double tau) {
  WorkTable table;
  for (const Group& group : study.groups) {
    std::vector<double> row;
    for (const Task& task : group.tasks) {
      std::vector<double> needed;
      for (const Descent& d : task.repetitions)
        needed.push_back(work_to_reach(work == Work::evaluations ? d.evaluations : d.seconds, d.excess, tau));
      const bool counts = task.verdict == Verdict::certified || task.verdict == Verdict::uncertified;
      std::sort(needed.begin(), needed.end());
      row.push_back(counts && !needed.empty() ? needed[(needed.size() - 1) / 2] : kInfinity);
    }
    table.push_back(std::move(row));
  }
  return table;
}

}  // namespace leastcost::app
