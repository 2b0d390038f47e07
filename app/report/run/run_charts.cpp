// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/plot/chart.hpp"
#include "app/plot/text.hpp"
#include "app/report/page/page.hpp"
#include "app/report/run/run_parts.hpp"

namespace leastcost::app {
namespace {

constexpr double kChartShape = 0.75;  ///< height over width, where there is no more room

Chart convergence_chart(const NumberTable& history, const std::string& column, const std::string& title) {
  const std::vector<double>& energy = history["energy"];
  const double least = *std::min_element(energy.begin(), energy.end());
  std::vector<double> excess;
  excess.reserve(energy.size());
  for (const double e : energy) excess.push_back((e - least) / std::max(std::abs(least), 1e-300));
  Chart chart;
  chart.title = "against " + title;
  chart.description = "Convergence of the solver against " + title + ", logarithmic";
  chart.x = {title};
  chart.x.whole = column != "seconds";
  chart.y = {"relative", ScaleKind::log};
  chart.series = {{"energy above the final one", history[column], excess, {0, true, true}},
                  {"predicted cost error", history[column], history["cost_error"], {1, true, true}}};
  chart.width = 318;
  chart.legend = column == "iteration";  // one for all three
  chart.height = 280;
  return chart;
}

/// Costs of the segments without the zero that ends an open path.
std::vector<double> segment_costs_of(const RunFiles& files) {
  std::vector<double> costs = files.path["segment_cost"];
  if (!files.result.flag("ring") && !costs.empty()) costs.pop_back();
  return costs;
}

}  // namespace

std::string convergence_part(const RunFiles& files) {
  if (files.history.rows() < 2) return paragraph("No iterations: the first path was not changed.");
  return figures(
      {svg(convergence_chart(files.history, "iteration", "iterations")),
       svg(convergence_chart(files.history, "evaluations", "evaluations")),
       svg(convergence_chart(files.history, "seconds", "seconds"))},
      "Energy relative to the final one, and the relative cost error that the solver predicts. The final point, with "
      "an excess of zero, is off the scale. An evaluation is an energy or a gradient of the whole path.");
}

std::string spacing_part(const RunFiles& files) {
  const std::vector<double> costs = segment_costs_of(files);
  if (costs.empty()) return paragraph("The path has no segments.");
  const double mean = std::accumulate(costs.begin(), costs.end(), 0.0) / static_cast<double>(costs.size());
  std::vector<double> number, deviation;
  for (const double c : costs) {
    number.push_back(static_cast<double>(number.size()) + 1);
    deviation.push_back(c / mean - 1);
  }
  const bool few = costs.size() <= 150;
  Chart absolute;
  absolute.title = "Cost per segment";
  absolute.description = "Cost of each segment along the path, from zero";
  absolute.x = {"segment"};
  absolute.x.whole = true;
  absolute.y = {files.result.text("cost.unit"), ScaleKind::linear, 0.0,
                1.25 * *std::max_element(costs.begin(), costs.end())};
  absolute.series = {{"", number, costs, {0, !few, few}}};
  Chart relative = absolute;
  relative.title = "Deviation from the mean";
  relative.description = "Cost of each segment over the mean, minus 1";
  relative.y = {"relative"};
  relative.series = {{"", number, deviation, {1, true, few}}};
  const double spread =
      *std::max_element(deviation.begin(), deviation.end()) - *std::min_element(deviation.begin(), deviation.end());
  return figures(
      {svg(absolute), svg(relative)},
      fmt::format("{} segments with a mean cost of {}; the most expensive and the cheapest differ by {} of it.",
                  costs.size(), number_text(mean, 6), number_text(spread, 2)));
}

std::string residual_part(const RunFiles& files) {
  if (files.residuals.empty()) return "";
  const NumberTable& table = files.residuals[0];
  const std::vector<double>&at = table["at_point"], &between = table["between"], &along = table["cumulative_cost"];
  const auto positive = [](double r) { return r > 0; };
  if (std::none_of(at.begin(), at.end(), positive) && std::none_of(between.begin(), between.end(), positive))
    return section("Distance from the domain", paragraph("Zero along the whole curve."));
  std::vector<double> middle = along;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) middle[i] = (along[i] + along[i + 1]) / 2;
  Chart chart;
  chart.title = "Distance from the domain";
  chart.description = "Distance of the delivered curve from the domain along the path, logarithmic";
  chart.x = {"cumulative cost"};
  chart.y = {"length", ScaleKind::log};
  chart.series = {{"points of the curve", along, at, {0, false, true}},
                  {"between them", middle, between, {1, false, true}}};
  chart.width = 640;
  return section("Distance from the domain",
                 figures({svg(chart)},
                         "Distance of the delivered curve (curve.csv). Distances of exactly zero are off the scale."));
}

Sketch coordinates_sketch(const RunFiles& files, const Look& look) {
  const std::vector<std::string>& names = files.coordinates;
  const std::string cost_unit = files.result.text("cost.unit");
  Chart chart;
  chart.title = "Coordinates along the path";
  chart.heading = !look.printed;
  chart.description = "Every coordinate of the path against the cumulative cost";
  chart.x = {cost_unit == "cost" ? "cumulative cost" : "cumulative cost (" + cost_unit + ")"};
  chart.y = {look.axis("coordinate")};
  for (std::size_t i = 0; i < names.size(); ++i)
    chart.series.push_back({names[i],
                            files.path["cumulative_cost"],
                            files.path[names[i]],
                            {static_cast<int>(i), true, files.path.rows() <= 30}});
  chart.width = look.width;
  chart.height = std::min(420.0, kChartShape * look.width);
  return sketch(chart);
}

Sketch convergence_sketch(const RunFiles& files, const Look& look) {
  if (files.history.rows() < 2) return {};
  Chart chart = convergence_chart(files.history, "iteration", "iterations");
  chart.heading = !look.printed;
  chart.width = look.width;
  chart.height = std::min(420.0, kChartShape * look.width);
  return sketch(chart);
}

}  // namespace leastcost::app
