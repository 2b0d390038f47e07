// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plot/text.hpp"
#include "app/report/page.hpp"
#include "app/report/study_parts.hpp"

namespace leastcost::app {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Look {
  const char *sign, *style, *words;
};

Look look_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified: return {"✓", "good", "certified"};
    case Verdict::other_minimum: return {"○", "other", "other minimum"};
    case Verdict::uncertified: return {"~", "mild", "uncertified"};
    case Verdict::failed: return {"×", "bad", "failed"};
    case Verdict::absent: break;
  }
  return {"", "", "not tried"};
}

std::string count_text(double count) { return count < 1e6 ? fmt::format("{:.0f}", count) : number_text(count); }

std::string hover_of(const Task& task) {
  std::string text = task.reason;
  if (task.evaluations.count > 0) text += fmt::format("; {} evaluations", count_text(task.evaluations.median));
  if (task.seconds.count > 0) text += "; " + duration_text(task.seconds.median);
  if (task.seconds.count > 1)
    text += fmt::format(" ({} to {}, {} repetitions)", duration_text(task.seconds.least),
                        duration_text(task.seconds.greatest), task.seconds.count);
  if (std::isfinite(task.excess)) text += "; above the best chain by " + number_text(task.excess, 2);
  if (std::isfinite(task.optimum_error)) text += "; off the optimum by " + number_text(task.optimum_error, 2);
  return text;
}

Cell cell_of(const Task& task) {
  const Look look = look_of(task.verdict);
  if (task.verdict == Verdict::absent) return {""};
  if (task.verdict == Verdict::failed) return {look.sign, look.style, hover_of(task)};
  return {fmt::format("{} {}\n{}", look.sign, duration_text(task.seconds.median), count_text(task.evaluations.median)),
          look.style, hover_of(task)};
}

/// How often each solver comes first (ties: all of them).
std::vector<int> firsts(const WorkTable& work, std::size_t solvers) {
  std::vector<int> count(solvers, 0);
  for (const std::vector<double>& row : work) {
    const double best = row.empty() ? kInfinity : *std::min_element(row.begin(), row.end());
    for (std::size_t s = 0; s < row.size(); ++s) count[s] += std::isfinite(best) && row[s] == best ? 1 : 0;
  }
  return count;
}

std::vector<std::size_t> order_of(const std::vector<double>& row) {
  std::vector<std::size_t> order;
  for (std::size_t s = 0; s < row.size(); ++s)
    if (std::isfinite(row[s])) order.push_back(s);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return row[a] < row[b]; });
  return order;
}

/// "newton 1.2 ms, lbfgs 1.4 ms".
template <class Text>
std::string leaders(const StudyAnalysis& study, const std::vector<double>& row, Text text) {
  std::string out;
  const std::vector<std::size_t> order = order_of(row);
  for (std::size_t k = 0; k < std::min<std::size_t>(2, order.size()); ++k)
    out += (k > 0 ? ", " : "") + study.solvers[order[k]] + " " + text(row[order[k]]);
  return out.empty() ? "none" : out;
}

}  // namespace

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "n/a";
  if (seconds < 1e-3) return number_text(1e6 * seconds, 2) + " µs";
  if (seconds < 1) return number_text(1e3 * seconds, 2) + " ms";
  return number_text(seconds, 2) + " s";
}

std::string solver_table(const StudyAnalysis& study) {
  const WorkTable evaluations = work_table(study, Work::evaluations, kSolved),
                  seconds = work_table(study, Work::seconds, kSolved);
  const std::vector<int> fewest = firsts(evaluations, study.solvers.size()),
                         fastest = firsts(seconds, study.solvers.size());
  Table table{{{"solver"},
               {"solved", true, "came within 1e-10 of the cost of the best chain that any solver found"},
               {"certified", true},
               {"other minimum", true, "certified, but a locally least-cost path that costs more"},
               {"uncertified", true},
               {"failed", true},
               {"fastest", true, "number of problems which it solved in the least time"},
               {"fewest evaluations", true, "number of problems which it solved with the fewest evaluations"},
               {"median time", true, "of its solves, whatever came out"},
               {"median evaluations", true, "energies and gradients of its solves"}},
              {},
              ""};
  for (std::size_t s = 0; s < study.solvers.size(); ++s) {
    int solved = 0, counts[5] = {};
    std::vector<double> times, work;
    for (std::size_t g = 0; g < study.groups.size(); ++g) {
      const Task& task = study.groups[g].tasks[s];
      ++counts[static_cast<int>(task.verdict)];
      solved += std::isfinite(evaluations[g][s]) ? 1 : 0;
      if (task.seconds.count > 0) times.push_back(task.seconds.median);
      if (task.evaluations.count > 0) work.push_back(task.evaluations.median);
    }
    const Spread time = spread_of(times), count = spread_of(work);
    const auto number = [&](Verdict v, const char* style) {
      const int n = counts[static_cast<int>(v)];
      return Cell{std::to_string(n), n > 0 ? style : ""};
    };
    table.rows.push_back({{study.solvers[s]},
                          {std::to_string(solved)},
                          number(Verdict::certified, "good"),
                          number(Verdict::other_minimum, "other"),
                          number(Verdict::uncertified, "mild"),
                          number(Verdict::failed, "bad"),
                          {std::to_string(fastest[s])},
                          {std::to_string(fewest[s])},
                          {time.count > 0 ? fmt::format("{:.2f} ms", 1e3 * time.median) : ""},
                          {count.count > 0 ? count_text(count.median) : ""}});
  }
  return html(table);
}

std::string success_table(const StudyAnalysis& study) {
  Table table{{{"problem"}}, {}, "matrix"};
  for (const std::string& solver : study.solvers) table.columns.push_back({solver});
  for (const Group& group : study.groups) {
    std::vector<Cell> row = {{group.label}};
    for (const Task& task : group.tasks) row.push_back(cell_of(task));
    table.rows.push_back(std::move(row));
  }
  return html(table);
}

std::string winners_table(const StudyAnalysis& study) {
  const WorkTable evaluations = work_table(study, Work::evaluations, kSolved),
                  seconds = work_table(study, Work::seconds, kSolved);
  Table table{
      {{"problem"},
       {"fastest, and next"},
       {"fewest evaluations, and next"},
       {"solved by", true},
       {"off the optimum", true, "the certified value of the fastest solver against the true least cost, relatively"},
       {"bar", true, "the error bar that the certificate gave it"}},
      {},
      ""};
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const std::vector<std::size_t> order = order_of(seconds[g]);
    const Task* best = order.empty() ? nullptr : &study.groups[g].tasks[order[0]];
    const bool known = best != nullptr && std::isfinite(best->optimum_error);
    table.rows.push_back({{study.groups[g].label},
                          {leaders(study, seconds[g], [](double t) { return duration_text(t); })},
                          {leaders(study, evaluations[g], count_text)},
                          {std::to_string(order.size())},
                          {known ? number_text(best->optimum_error, 2) : ""},
                          {known ? number_text(best->bar, 2) : ""}});
  }
  return html(table);
}

std::string growth_table(const StudyAnalysis& study) {
  const WorkTable work = work_table(study, Work::evaluations, kSolved);
  Table table{{{"problem"}, {"solver"}, {"fewest points", true}, {"most points", true}, {"growth", true}}, {}, ""};
  std::vector<std::string> problems;
  for (const Group& g : study.groups)
    if (std::find(problems.begin(), problems.end(), g.problem + g.rest) == problems.end())
      problems.push_back(g.problem + g.rest);
  for (const std::string& problem : problems) {
    std::size_t least = study.groups.size(), most = least;
    for (std::size_t g = 0; g < study.groups.size(); ++g) {
      if (study.groups[g].problem + study.groups[g].rest != problem) continue;
      if (least == study.groups.size() || study.groups[g].points < study.groups[least].points) least = g;
      if (most == study.groups.size() || study.groups[g].points > study.groups[most].points) most = g;
    }
    if (study.groups[least].points == study.groups[most].points) continue;
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      const double a = work[least][s], b = work[most][s], growth = b / a;
      const bool known = std::isfinite(a) && std::isfinite(b);
      const std::string name =
          study.groups[least].problem + (study.groups[least].rest.empty() ? "" : ", " + study.groups[least].rest);
      table.rows.push_back({{name},
                            {study.solvers[s]},
                            {std::isfinite(a) ? fmt::format("{:.0f}", a) : "not reached"},
                            {std::isfinite(b) ? fmt::format("{:.0f}", b) : "not reached"},
                            {known ? fmt::format("{:.1f}", growth) : "", known && growth <= 2 ? "good"
                                                                         : known              ? "bad"
                                                                                              : ""}});
    }
  }
  return table.rows.empty() ? "" : html(table);
}

}  // namespace leastcost::app
