// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/study/study_analysis.hpp"

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
/// Of certified costs, relatively and beside their error bars.
constexpr double kSameCost = 1e-10;
constexpr double kTie = 1.1;        ///< between times
constexpr double kRounding = 1e-9;  ///< of relative costs, generously
constexpr double kNothing = 1e-14;  ///< the same, at best

double or_nan(const std::optional<double>& value) { return value.value_or(std::nan("")); }

/// What makes rows comparable, in the order in which it is shown.
std::vector<std::string> key_of(const RunRow& row) {
  std::vector<std::string> key = {row.problem, row.points ? std::to_string(*row.points) : "", row.kernel,
                                  row.seed ? std::to_string(*row.seed) : ""};
  key.insert(key.end(), row.swept.begin(), row.swept.end());
  return key;
}

/// A list of different values, each with its position.
template <class T>
class Places {
 public:
  std::size_t of(const T& value) {
    const auto [place, is_new] = places_.try_emplace(value, list_.size());
    if (is_new) list_.push_back(value);
    return place->second;
  }
  const std::vector<T>& list() const { return list_; }

 private:
  std::vector<T> list_;
  std::map<T, std::size_t> places_;
};

/// What a group is measured against.
struct Best {
  double energy = kInfinity;         ///< of all chains
  double cost = kInfinity, bar = 0;  ///< the least certified one; infinity: nothing was certified
};

using Traces = std::map<std::pair<long, long>, std::vector<const TraceRow*>>;

class Analysis {
 public:
  Analysis(const RunTable& runs, const std::vector<TraceRow>& traces) : runs_(runs) {
    for (const TraceRow& t : traces) traces_[{t.cell, t.repetition}].push_back(&t);
  }

  StudyAnalysis study() {
    Places<std::vector<std::string>> groups;
    Places<std::string> solvers;
    for (const RunRow& row : runs_.rows) {
      const std::size_t group = groups.of(key_of(row)), solver = solvers.of(row.solver);
      if (group == rows_.size()) rows_.emplace_back();
      rows_[group][solver].push_back(&row);
    }
    out_.solvers = solvers.list();
    const std::vector<std::vector<std::string>>& keys = groups.list();
    const std::vector<char> varies = varying(keys);
    for (std::size_t g = 0; g < keys.size(); ++g) out_.groups.push_back(make_group(g, keys[g], varies));
    return std::move(out_);
  }

 private:
  /// Which parts of the key tell groups of one problem apart. Seeds do only where nothing else does: they follow the
  /// cell.
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
    group.label = group.problem + (varies[1] != 0 && !key[1].empty() ? ", n\u00a0=\u00a0" + key[1] : "");
    if (!group.rest.empty()) group.label += ", " + group.rest;
    const Best best = best_of(g);
    group.tasks.resize(out_.solvers.size());
    for (const auto& [solver, rows] : rows_[g]) group.tasks[solver] = make_task(rows, best);
    return group;
  }

  /// Of all rows of the group with a path that is one: a collapsed chain has no energy to speak of.
  Best best_of(std::size_t g) const {
    Best best;
    for (const auto& [solver, rows] : rows_[g])
      for (const RunRow* row : rows) {
        if (row->outcome != outcome::kOk || row->status == "collapsed") continue;
        if (row->final_energy && std::isfinite(*row->final_energy))
          best.energy = std::min(best.energy, *row->final_energy);
        if (!is_certified(*row) || !(or_nan(row->cost) < best.cost)) continue;
        best.cost = *row->cost;
        best.bar = bar_of(*row);
      }
    return best;
  }

  static bool is_certified(const RunRow& row) { return row.outcome == outcome::kOk && row.status == "certified"; }
  static double bar_of(const RunRow& row) {
    const double bar = or_nan(row.cost_error_bar);
    return std::isfinite(bar) ? bar : 0;
  }

  static double excess(double energy, const Best& best, const RunRow& row) {
    const double slope = or_nan(row.energy_slope);
    return slope > 0 ? std::max(0.0, energy - best.energy) / slope : std::nan("");
  }

  /// What is left of the way down; nothing within rounding of the best chain, also where the first one lay there.
  static double left(double energy, const Best& best, const RunRow& row) {
    if (excess(energy, best, row) <= kNothing) return 0;
    const double way = or_nan(row.initial_energy) - best.energy;
    return way > 0 ? std::max(0.0, energy - best.energy) / way : std::nan("");
  }

  static bool same_cost(const RunRow& row, const Best& best) {
    return is_certified(row) &&
           or_nan(row.cost) - best.cost <= bar_of(row) + best.bar + kSameCost * std::abs(best.cost);
  }

  Task make_task(const std::vector<const RunRow*>& rows, const Best& best) const {
    const RunRow& first = *rows[0];
    Task task;
    std::vector<double> seconds, evaluations;
    for (const RunRow* row : rows) {
      task.repetitions.push_back(descent_of(*row, best));
      if (row->outcome == outcome::kCannotSolve) continue;  // it did no work
      if (row->s_solve) seconds.push_back(*row->s_solve);
      if (row->evaluations) evaluations.push_back(work_of(*row->evaluations, row->iterations.value_or(0)));
    }
    task.seconds = spread_of(std::move(seconds));
    task.evaluations = spread_of(std::move(evaluations));
    task.descent = task.repetitions[0];
    task.same_cost = task.descent.same_cost;
    task.excess = excess(or_nan(first.final_energy), best, first);
    task.solver_error = or_nan(first.solver_error);
    task.optimum_error = or_nan(first.optimum_error);
    task.bar = or_nan(first.cost_error_bar) / std::abs(or_nan(first.optimum));
    task.chain_error = std::abs(or_nan(first.chain_cost) - or_nan(first.optimum)) / std::abs(or_nan(first.optimum));
    task.verdict = verdict_of(first, task);
    task.reason = reason_of(first, task.verdict);
    return task;
  }

  /// The trace of a row, and at its end the delivered chain. A method with a functional of its own (georce) traces
  /// that: what lies below the energy that was delivered cannot be an energy, and only the end counts.
  Descent descent_of(const RunRow& row, const Best& best) const {
    Descent out;
    if (row.outcome != outcome::kOk || row.status == "collapsed") return out;
    out.same_cost = same_cost(row, best);
    out.all_evaluations = work_of(row.evaluations.value_or(0), row.iterations.value_or(0));
    out.all_seconds = or_nan(row.s_solve);
    const double delivered = or_nan(row.final_energy), slope = or_nan(row.energy_slope);
    const auto found = traces_.find({row.cell, row.repetition});
    if (found != traces_.end()) {
      const std::vector<const TraceRow*>& rows = found->second;
      const bool own_functional = std::any_of(
          rows.begin(), rows.end(), [&](const TraceRow* t) { return t->energy < delivered - kRounding * slope; });
      for (const TraceRow* t : own_functional ? std::vector<const TraceRow*>() : rows)
        add(out, work_of(t->evaluations, t->iteration), t->seconds, t->energy, best, row);
    }
    const double last = excess(delivered, best, row);
    const bool reached = !out.excess.empty() && *std::min_element(out.excess.begin(), out.excess.end()) <= last;
    if (std::isfinite(last) && !reached) add(out, out.all_evaluations, out.all_seconds, delivered, best, row);
    return out;
  }

  static void add(Descent& descent, double evaluations, double seconds, double energy, const Best& best,
                  const RunRow& row) {
    descent.evaluations.push_back(evaluations);
    descent.seconds.push_back(seconds);
    descent.excess.push_back(excess(energy, best, row));
    descent.left.push_back(left(energy, best, row));
  }

  /// Evaluations of the whole path; an iteration is at least the work of one, also where a method evaluates something
  /// else.
  static double work_of(long evaluations, long iterations) {
    return static_cast<double>(std::max({evaluations, iterations, 1L}));
  }

  static Verdict verdict_of(const RunRow& row, const Task& task) {
    if (row.outcome == outcome::kCannotSolve) return Verdict::refused;
    if (row.outcome != outcome::kOk) return Verdict::failed;
    if (row.status != "certified") return Verdict::uncertified;
    return task.same_cost || task.excess <= kSolved ? Verdict::certified : Verdict::other_minimum;
  }

  static std::string reason_of(const RunRow& row, Verdict verdict) {
    if (verdict == Verdict::refused) return "refused: " + row.message;
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

StudyAnalysis first_groups(const StudyAnalysis& study, std::size_t most) {
  const auto count = static_cast<std::ptrdiff_t>(std::min(most, study.groups.size()));
  return {study.solvers, {study.groups.begin(), study.groups.begin() + count}};
}

WorkTable work_table(const StudyAnalysis& study, Work work, double tau, Test test) {
  const bool count = work == Work::evaluations;
  WorkTable table;
  for (const Group& group : study.groups) {
    std::vector<double> row;
    for (const Task& task : group.tasks) {
      std::vector<double> needed;
      for (const Descent& d : task.repetitions) {
        const double reached =
            work_to_reach(count ? d.evaluations : d.seconds, test == Test::excess ? d.excess : d.left, tau);
        const double all = count ? d.all_evaluations : d.all_seconds;
        needed.push_back(d.same_cost && !std::isfinite(reached) && std::isfinite(all) ? all : reached);
      }
      const bool counts = task.verdict == Verdict::certified || task.verdict == Verdict::uncertified;
      std::sort(needed.begin(), needed.end());
      row.push_back(counts && !needed.empty() ? needed[(needed.size() - 1) / 2] : kInfinity);
    }
    table.push_back(std::move(row));
  }
  return table;
}

std::vector<std::size_t> problems_won(const WorkTable& work, Work kind, std::size_t solvers) {
  std::vector<std::size_t> count(solvers, 0);
  for (const std::vector<double>& row : work) {
    const double best = row.empty() ? kInfinity : *std::min_element(row.begin(), row.end());
    if (!std::isfinite(best)) continue;
    for (std::size_t s = 0; s < row.size(); ++s)
      count[s] += row[s] <= (kind == Work::seconds ? kTie : 1) * best ? 1 : 0;
  }
  return count;
}

}  // namespace leastcost::app
