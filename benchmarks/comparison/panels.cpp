// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <fstream>
#include <map>

#include "app/plot/chart.hpp"
#include "benchmarks/comparison/table.hpp"

namespace leastcost::comparison {
namespace {

/// Errors below this are rounding: exact for the chart.
constexpr double kLeastError = 1e-10;

bool is_duck(const Row& r) { return r.mesh.rfind("duck", 0) == 0 && r.pair == "far"; }

/// One line per method: its mean over the far pairs of the duck, against the number of vertices.
template <class Value>
app::Chart chart_of(const std::vector<Row>& rows, const std::vector<std::string>& methods, std::string title,
                    std::string unit, Value value) {
  app::Chart chart;
  chart.title = std::move(title);
  chart.description = chart.title + ", far pairs of the duck at four resolutions";
  chart.x.title = "vertices";
  chart.y.title = std::move(unit);
  chart.x.kind = chart.y.kind = app::ScaleKind::log;
  for (const std::string& method : methods) {
    std::map<int, std::pair<double, int>> sums;
    for (const Row& r : rows)
      if (is_duck(r) && r.method == method && r.found()) {
        sums[r.vertices].first += value(r);
        ++sums[r.vertices].second;
      }
    app::Series series;
    series.name = method;
    series.style.number = static_cast<int>(chart.series.size());
    series.style.markers = true;
    for (const auto& [vertices, sum] : sums) {
      series.x.push_back(vertices);
      series.y.push_back(sum.first / sum.second);
    }
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace

void write_panels(const std::filesystem::path& folder, const std::vector<Row>& rows,
                  const std::vector<History>& histories) {
  std::filesystem::create_directories(folder);
  const auto seconds = [](const Row& r) { return 1e-3 * r.query_ms; };
  const auto error = [](const Row& r) { return 100 * std::max(kLeastError, r.error()); };
  std::vector<app::Chart> charts;
  charts.push_back(chart_of(rows, {"CH", "ICH", "VTP", "VFCS", "ours"}, "b: exact methods", "CPU seconds", seconds));
  charts.push_back(
      chart_of(rows, {"Dijkstra", "FMM", "Heat", "VFCS", "ours"}, "c: approximate methods", "CPU seconds", seconds));
  charts.push_back(
      chart_of(rows, {"SR", "LS", "DE", "SLO", "LLM", "VFCS", "ours"}, "d: local methods", "CPU seconds", seconds));
  charts.push_back(chart_of(rows, {"Dijkstra", "FMM", "Heat", "VFCS"}, "e: error of the length", "error, %", error));
  app::Chart f;
  f.title = "f: convergence";
  f.description = "Error of the length against iterations, one far pair of the duck";
  f.x.title = "iterations";
  f.y.title = "error, %";
  f.x.kind = f.y.kind = app::ScaleKind::log;
  for (const History& h : histories) {
    app::Series series;
    series.name = h.method;
    series.style.number = static_cast<int>(f.series.size());
    for (std::size_t i = 0; i < h.iterations.size(); ++i) {
      series.x.push_back(std::max(0.5, h.iterations[i]));  // a logarithmic axis has no zero
      series.y.push_back(100 * std::max(kLeastError, h.errors[i]));
    }
    f.series.push_back(std::move(series));
  }
  charts.push_back(std::move(f));
  const char* names = "bcdef";
  for (std::size_t i = 0; i < charts.size(); ++i)
    std::ofstream(folder / (std::string("panel_") + names[i] + ".svg")) << app::svg(charts[i], true);
  std::ofstream(folder / "panels.svg") << app::panels_svg("The comparison of VFCS Sec. 5, repeated",
                                                          "Time and error of mesh geodesics by method", charts);
}

}  // namespace leastcost::comparison
