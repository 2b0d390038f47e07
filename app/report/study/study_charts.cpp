// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/study/study_parts.hpp"

namespace leastcost::app {
namespace {

constexpr double kPage = 1008, kGap = 26;  ///< width of a page and between its figures, px

/// Gives panels that share the legend of the last one the same width, so that they fill a line of the page: up to three
/// in one.
void share_width(std::vector<Chart>& panels) {
  if (panels.empty()) return;
  const double legend = legend_width(panels.back().series);
  const auto columns = static_cast<double>(std::min<std::size_t>(panels.size(), 3));
  for (Chart& chart : panels) {
    chart.legend = &chart == &panels.back();
    chart.width = std::floor((kPage - legend - (columns - 1) * kGap) / columns) + (chart.legend ? legend : 0);
  }
}

constexpr double kFinest = 1e-3;  ///< step of a share: a third of a pixel

/// Steps from the left edge of the chart to the right one.
Series steps_of(const std::string& name, const Profile& profile, double from, double to, int number) {
  Series s{name, {from}, {0}, {number}, {}, {}, true};
  for (std::size_t i = 0; i < profile.at.size(); ++i) {
    const bool told = profile.share[i] - s.y.back() >= kFinest || i + 1 == profile.at.size();
    if (!told) continue;
    s.x.push_back(std::max(from, profile.at[i]));
    s.y.push_back(profile.share[i]);
  }
  s.x.push_back(to);
  s.y.push_back(s.y.back());
  s.marks = 3;
  return s;
}

Chart profile_chart(const StudyAnalysis& study, const std::vector<Profile>& profiles, const std::string& title,
                    const std::string& x) {
  double most = 2;
  for (const Profile& p : profiles)
    if (!p.at.empty()) most = std::max(most, p.at.back());
  Chart chart;
  chart.title = title;
  chart.description = title + ": the share of problems that each solver solves, against the allowed work";
  chart.x = {x, ScaleKind::log, 1.0, 1.3 * most};
  chart.y = {"share of problems", ScaleKind::linear, 0.0, 1.02};
  for (std::size_t s = 0; s < profiles.size(); ++s)
    chart.series.push_back(steps_of(study.solvers[s], profiles[s], 1, 1.3 * most, static_cast<int>(s)));
  chart.height = 360;
  return chart;
}

/// Work as profiles take it: times of zero do not exist.
WorkTable positive(WorkTable work) {
  for (std::vector<double>& row : work)
    for (double& w : row) w = std::max(w, 1e-9);
  return work;
}

/// Groups of one problem that differ in the number of points, by points.
std::map<std::string, std::map<long, std::size_t>> by_points(const StudyAnalysis& study,
                                                             std::vector<std::string>& order) {
  std::map<std::string, std::map<long, std::size_t>> out;
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const Group& group = study.groups[g];
    const std::string name = group.problem + (group.rest.empty() ? "" : ", " + group.rest);
    if (out.count(name) == 0) order.push_back(name);
    out[name].emplace(group.points, g);
  }
  std::erase_if(order, [&](const std::string& name) { return out[name].size() < 2; });
  return out;
}

StudyFigure against_points(const StudyAnalysis& study, Work kind, const std::string& what, const std::string& file) {
  StudyFigure figure{file, "", "", {}};
  const WorkTable work = work_table(study, kind, kSolved);
  std::vector<std::string> names;
  auto problems = by_points(study, names);
  for (const std::string& name : names) {
    Chart chart;
    chart.title = name;
    chart.description = what + " to a relative cost error of 1e-10 against the number of points, one line per solver";
    chart.x = {"points n", ScaleKind::log};
    chart.y = {what, ScaleKind::log};
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      Series series{study.solvers[s], {}, {}, {static_cast<int>(s), true, true}};
      for (const auto& [points, g] : problems[name]) {
        if (!std::isfinite(work[g][s])) continue;
        series.x.push_back(static_cast<double>(points));
        series.y.push_back(std::max(work[g][s], 1e-9));
      }
      chart.series.push_back(std::move(series));
    }
    chart.height = 400;
    figure.panels.push_back(std::move(chart));
  }
  share_width(figure.panels);
  figure.title = what + " to a relative cost error of 1e-10, against the number of points";
  figure.description = figure.title + ", for every solver; a solver that never reaches it has no point";
  return figure;
}

/// The first solver that certified the group, in the order of the study.
const Task* first_certified(const Group& group) {
  for (const Task& task : group.tasks)
    if (task.verdict == Verdict::certified) return &task;
  return nullptr;
}

/// Errors of the first certified solver per number of segments; a row does not say whether it is a ring, so that this
/// is n + 1.
Series order_series(const StudyAnalysis& study, const std::string& name, const std::map<long, std::size_t>& by_points,
                    double Task::*error) {
  Series series{name, {}, {}};
  for (const auto& [points, g] : by_points) {
    const Task* task = first_certified(study.groups[g]);
    if (task == nullptr || !(task->*error > 0)) continue;
    series.x.push_back(static_cast<double>(points) + 1);
    series.y.push_back(task->*error);
  }
  return series;
}

/// One line per problem, all of them in every panel: a problem has one colour.
Chart order_chart(const StudyAnalysis& study, const std::string& title, double Task::*error) {
  Chart chart;
  chart.title = title;
  chart.description = title + " against the number of segments, relative to the true least cost";
  chart.x = {"segments n + 1", ScaleKind::log};
  chart.y = {"relative error", ScaleKind::log};
  std::vector<std::string> names;
  auto problems = by_points(study, names);
  for (const std::string& name : names) {
    chart.series.push_back(order_series(study, name, problems[name], error));
    chart.series.back().style = {static_cast<int>(chart.series.size()) - 1, true, true};
  }
  chart.height = 340;
  return chart;
}

bool shows_something(const Chart& chart) {
  return std::any_of(chart.series.begin(), chart.series.end(), [](const Series& s) { return s.x.size() > 1; });
}

Cell slope_cell(const Series& series) {
  constexpr double kLeastError = 1e-13;  // below this, rounding has its say
  if (series.x.size() < 2) return {"", ""};
  if (const auto slope = log_log_slope(series.x, series.y, kLeastError))
    return {(*slope < 0 ? "−" : "") + fmt::format("{:.1f}", std::abs(*slope))};
  return {"rounding", "mild", "fewer than two errors above 1e-13"};
}

/// The descent with the points left out that no one could tell from their neighbours.
Series descent_series(const StudyAnalysis& study, const Group& group, std::size_t s, const std::vector<double>& x,
                      const std::vector<double>& excess) {
  constexpr double kZero = 1e-16, kTold = 1.15;
  Series series{study.solvers[s], {}, {}, {static_cast<int>(s)}};
  series.marks = 2;
  if (group.tasks[s].verdict == Verdict::other_minimum) series.name += " (other minimum)";
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double y = std::max(excess[i], kZero);
    const bool last = i + 1 == x.size(), first = series.y.empty();
    const bool told = !first && (y < series.y.back() / kTold || y > series.y.back() * kTold);
    if (!first && !last && !told) continue;
    series.x.push_back(x[i]);
    series.y.push_back(y);
  }
  return series;
}

std::string descents(const StudyAnalysis& study, const Group& group) {
  std::vector<Chart> panels;
  for (const bool of_time : {false, true}) {
    Chart chart;
    const std::string what = of_time ? "seconds" : "evaluations";
    chart.title = "against " + what;
    chart.description = "Relative cost excess of every solver against " + what;
    chart.x = {what, ScaleKind::log};
    chart.y = {"excess", ScaleKind::log};
    for (std::size_t s = 0; s < study.solvers.size(); ++s) {
      const Descent& d = group.tasks[s].descent;
      if (!d.excess.empty())
        chart.series.push_back(descent_series(study, group, s, of_time ? d.seconds : d.evaluations, d.excess));
    }
    if (chart.series.empty()) return "";
    chart.height = 330;
    panels.push_back(std::move(chart));
  }
  share_width(panels);
  return figures({svg(panels[0]), svg(panels[1])});
}

/// Two profiles that share a legend.
StudyFigure profile_figure(const std::string& file, const std::string& title, const std::string& description,
                           Chart first, Chart second) {
  StudyFigure figure{file, title, description, {std::move(first), std::move(second)}};
  share_width(figure.panels);
  return figure;
}

}  // namespace

StudyFigure performance_figure(const StudyAnalysis& study) {
  const auto profiles = [&](Work work) { return performance_profiles(positive(work_table(study, work, kSolved))); };
  return profile_figure(
      "performance.svg", "Performance profiles",
      "Share of problems that each solver solves within a multiple of the work of the best solver for each",
      profile_chart(study, profiles(Work::seconds), "by time", "times the fastest"),
      profile_chart(study, profiles(Work::evaluations), "by evaluations", "times the fewest"));
}

StudyFigure data_figure(const StudyAnalysis& study) {
  const std::vector<double> units(study.groups.size(), 1.0);
  const auto profiles = [&](double tau) {
    return data_profiles(positive(work_table(study, Work::evaluations, tau, Test::left)), units);
  };
  return profile_figure("data.svg", "Data profiles",
                        "Share of problems on which each solver reaches the fraction τ within a number of evaluations",
                        profile_chart(study, profiles(1e-5), "τ = 10⁻⁵", "evaluations"),
                        profile_chart(study, profiles(1e-10), "τ = 10⁻¹⁰", "evaluations"));
}

StudyFigure evaluations_figure(const StudyAnalysis& study) {
  return against_points(study, Work::evaluations, "evaluations", "evaluations.svg");
}

StudyFigure seconds_figure(const StudyAnalysis& study) {
  return against_points(study, Work::seconds, "seconds", "seconds.svg");
}

StudyFigure order_figure(const StudyAnalysis& study) {
  StudyFigure figure{"order.svg",
                     "Error against the number of segments",
                     "Error of the chain and of the reported value, relative to the true least cost",
                     {}};
  for (Chart chart : {order_chart(study, "the chain's cost", &Task::chain_error),
                      order_chart(study, "the reported value", &Task::optimum_error)})
    if (shows_something(chart)) figure.panels.push_back(std::move(chart));
  share_width(figure.panels);
  return figure;
}

std::string order_table(const StudyAnalysis& study) {
  std::vector<std::string> names;
  auto problems = by_points(study, names);
  Table table{{{"problem"}, {"slope of the chain's cost", true}, {"slope of the reported value", true}}, {}, ""};
  for (const std::string& name : names)
    table.rows.push_back({{name},
                          slope_cell(order_series(study, name, problems[name], &Task::chain_error)),
                          slope_cell(order_series(study, name, problems[name], &Task::optimum_error))});
  return html(table);
}

std::string convergence_charts(const StudyAnalysis& study) {
  std::string out;
  for (const Group& group : study.groups) {
    const std::string drawn = descents(study, group);
    if (!drawn.empty())
      out += fmt::format("<details class=\"sub\"><summary>{}</summary>\n{}</details>\n", escaped(group.label), drawn);
  }
  if (out.empty()) return "";
  return paragraph(
             "Relative cost excess over the best chain of all solvers, in the first repetition. On a mesh, chains of "
             "the same path can have different energies and do not meet here.",
             "soft") +
         out;
}

}  // namespace leastcost::app
