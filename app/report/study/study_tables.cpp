// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/study/study_parts.hpp"

namespace leastcost::app {
namespace {

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

/// A problem, and its groups with the fewest and the most points.
struct Ends {
  std::string name;
  std::size_t least, most;
};

/// Of all problems with more than one number of points.
std::vector<Ends> ends_of(const StudyAnalysis& study) {
  std::vector<Ends> ends;
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const Group& group = study.groups[g];
    const std::string name = group.problem + (group.rest.empty() ? "" : ", " + group.rest);
    auto found = std::find_if(ends.begin(), ends.end(), [&](const Ends& e) { return e.name == name; });
    if (found == ends.end()) found = ends.insert(ends.end(), {name, g, g});
    if (group.points < study.groups[found->least].points) found->least = g;
    if (group.points > study.groups[found->most].points) found->most = g;
  }
  std::erase_if(ends, [](const Ends& e) { return e.least == e.most; });
  return ends;
}

/// "13 → 21", good while it does not double.
Cell growth_cell(double from, double to) {
  const auto text = [](double n) { return std::isfinite(n) ? count_text(n) : std::string("not reached"); };
  const bool flat = std::isfinite(from) && to <= 2 * from;
  return {text(from) + " → " + text(to), flat ? "good" : "bad plain"};
}

/// "12", or "≥ 300" where the solver spent so much without getting there.
Cell ratio_cell(double seconds, const Task& task, double reference) {
  if (!std::isfinite(reference) || task.verdict == Verdict::absent) return {""};
  const auto text = [](double ratio) { return number_text(ratio, ratio < 10 ? 2 : 3); };
  if (std::isfinite(seconds)) return {text(seconds / reference), "", duration_text(seconds)};
  if (task.seconds.count == 0 || task.verdict == Verdict::other_minimum) return {"–", "mild", task.reason};
  return {"≥ " + text(task.seconds.median / reference), "bad plain", "not reached: " + task.reason};
}

}  // namespace

std::string count_text(double count) { return count < 1e6 ? fmt::format("{:.0f}", count) : number_text(count); }

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds)) return "n/a";
  if (seconds < 1e-3) return number_text(1e6 * seconds, 2) + "\u00a0µs";
  if (seconds < 1) return number_text(1e3 * seconds, 2) + "\u00a0ms";
  return number_text(seconds, 2) + "\u00a0s";
}

std::string solver_table(const StudyAnalysis& study) {
  const WorkTable evaluations = work_table(study, Work::evaluations, kSolved),
                  seconds = work_table(study, Work::seconds, kSolved);
  const std::vector<std::size_t> fewest = problems_won(evaluations, Work::evaluations, study.solvers.size()),
                                 fastest = problems_won(seconds, Work::seconds, study.solvers.size());
  Table table{{{"solver"},
               {"solved", true,
                "came within a relative cost excess of 1e-10 over the best chain of all solvers at some time in its "
                "run, or was certified at the least certified cost"},
               {"certified", true},
               {"other min.", true, "certified, but a locally least-cost path that costs more"},
               {"uncertified", true, "includes collapsed and interrupted ones"},
               {"refused", true, "the solver does not support the problem"},
               {"failed", true, "no path"},
               {"fastest", true, "number of problems that it solved in the least time; ties within 10 % count"},
               {"fewest eval.", true, "number of problems that it solved with the fewest evaluations; ties count"},
               {"median time", true, "of its solves, whatever the outcome"},
               {"median eval.", true, "energies and gradients of its solves"}},
              {},
              "counts"};
  for (std::size_t s = 0; s < study.solvers.size(); ++s) {
    int solved = 0, counts[kVerdicts] = {};
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
                          number(Verdict::refused, "mild"),
                          number(Verdict::failed, "bad"),
                          {std::to_string(fastest[s])},
                          {std::to_string(fewest[s])},
                          {time.count > 0 ? fmt::format("{:.2f}\u00a0ms", 1e3 * time.median) : ""},
                          {count.count > 0 ? count_text(count.median) : ""}});
  }
  return html(table);
}

std::string winners_table(const StudyAnalysis& study) {
  const WorkTable evaluations = work_table(study, Work::evaluations, kSolved),
                  seconds = work_table(study, Work::seconds, kSolved);
  Table table{{{"problem"},
               {"fastest, and next"},
               {"fewest evaluations, and next"},
               {"solved by", true},
               {"off the optimum", true, "the certified value of the fastest solver relative to the true least cost"},
               {"bar", true, "the error bar from the certificate"}},
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
  const std::vector<Ends> ends = ends_of(study);
  if (ends.empty()) return "";
  Table table{{{"solver"}}, {}, ""};
  for (const Ends& e : ends)
    table.columns.push_back(
        {fmt::format("{}, n\u00a0=\u00a0{} to {}", e.name, study.groups[e.least].points, study.groups[e.most].points)});
  for (std::size_t s = 0; s < study.solvers.size(); ++s) {
    std::vector<Cell> row = {{study.solvers[s]}};
    for (const Ends& e : ends) row.push_back(growth_cell(work[e.least][s], work[e.most][s]));
    table.rows.push_back(std::move(row));
  }
  return "<h3>From the fewest points to the most</h3>\n" +
         paragraph("Evaluations; bold where they vary by less than a factor of two.", "soft") + html(table);
}

std::string ratio_table(const StudyAnalysis& study) {
  const WorkTable work = work_table(study, Work::seconds, kSolved);
  Table table{{{"solver"}}, {}, "matrix"};
  std::vector<std::size_t> columns;
  for (const Ends& e : ends_of(study))
    for (std::size_t g = 0; g < study.groups.size(); ++g)
      if (study.groups[g].problem == study.groups[e.least].problem &&
          study.groups[g].rest == study.groups[e.least].rest)
        columns.push_back(g);
  if (columns.empty()) return "";
  for (const std::size_t g : columns) table.columns.push_back({study.groups[g].label, true});
  for (std::size_t s = 0; s < study.solvers.size(); ++s) {
    std::vector<Cell> row = {{study.solvers[s]}};
    for (const std::size_t g : columns) row.push_back(ratio_cell(work[g][s], study.groups[g].tasks[s], work[g][0]));
    table.rows.push_back(std::move(row));
  }
  return "<h3>As multiples of " + escaped(study.solvers[0]) + "</h3>\n" +
         paragraph("Time to the same excess; ≥ where a solver used that time without reaching it.", "soft") +
         html(table);
}

}  // namespace leastcost::app
