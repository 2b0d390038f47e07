// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// One row per problem, one dot per solver: how far the certified value is from the true least cost.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/plot/text.hpp"
#include "app/report/study/study_parts.hpp"

namespace leastcost::app {
namespace {

constexpr double kRow = 15, kTop = 34, kBottom = 44, kPlot = 560, kLeast = 1e-17;

struct Row {
  std::string label;
  std::vector<double> others;  ///< errors of certified solvers
  double best = 0, bar = 0;    ///< of the first certified solver of the study, and its error bar
  std::string solver;
};

/// Rows of problems whose optimum is known; of several numbers of points the largest.
std::vector<Row> rows_of(const StudyAnalysis& study) {
  std::map<std::string, long> most;
  for (const Group& g : study.groups) most[g.problem + g.rest] = std::max(most[g.problem + g.rest], g.points);
  std::vector<Row> rows;
  for (const Group& group : study.groups) {
    if (group.points != most[group.problem + group.rest]) continue;
    Row row{group.label, {}, std::nan(""), std::nan(""), ""};
    for (std::size_t s = 0; s < group.tasks.size(); ++s) {
      const Task& task = group.tasks[s];
      if (task.verdict != Verdict::certified || !std::isfinite(task.optimum_error)) continue;
      row.others.push_back(std::max(task.optimum_error, kLeast));
      if (!std::isnan(row.best)) continue;
      row.best = row.others.back();
      row.bar = std::max(task.bar, kLeast);
      row.solver = study.solvers[s];
    }
    if (!row.others.empty()) rows.push_back(std::move(row));
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.best < b.best; });
  return rows;
}

}  // namespace

std::string accuracy_svg(const StudyAnalysis& study, bool standalone) {
  const std::vector<Row> rows = rows_of(study);
  if (rows.empty()) return "";
  std::vector<double> values;
  double label = 0;
  for (const Row& row : rows) {
    values.insert(values.end(), row.others.begin(), row.others.end());
    if (std::isfinite(row.bar)) values.push_back(row.bar);
    label = std::max(label, 12.5 * text_width(row.label));  // with room: widths are estimates
  }
  const Range range = range_of(values, ScaleKind::log);
  const double left = label + 14, height = kTop + kRow * static_cast<double>(rows.size()), width = left + kPlot + 20;
  const auto x = [&](double value) { return left + kPlot * position_in(ScaleKind::log, range, value); };
  std::string out = "<text class=\"title\" x=\"0\" y=\"13\">Distance from the true least cost</text>\n";
  for (const Tick& t : ticks(ScaleKind::log, range, 9)) {
    out += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}V{:.1f}\"/>", x(t.at), kTop - 6, height);
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x(t.at), height + 16,
                       t.label);
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Row& row = rows[k];
    const double y = kTop + kRow * (static_cast<double>(k) + 0.5);
    out += fmt::format(
        "<g><title>{}: {} off by {}, bar {}</title><text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>",
        escaped(row.label), escaped(row.solver), number_text(row.best, 2), number_text(row.bar, 2), left - 8, y + 3.8,
        escaped(row.label));
    for (const double error : row.others) out += marker({0, false, true, true}, x(error), y, 2.2);
    if (std::isfinite(row.bar))
      out += fmt::format("<path class=\"s s1\" d=\"M{:.1f} {:.1f}v9\"/>", x(row.bar), y - 4.5);
    out += marker({0, false, true}, x(row.best), y, 3.4) + "</g>\n";
  }
  out += fmt::format("<path class=\"axis\" d=\"M{:.1f} {:.1f}h{}\"/>", left, height, kPlot);
  out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">relative error</text>\n", left + kPlot / 2,
                     height + 34);
  return svg_element(
      "Distance from the true least cost",
      "One dot per solver and problem: relative error of the certified value, with a stroke for the error bar", width,
      height + kBottom, out, standalone);
}

}  // namespace leastcost::app
