// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/path_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include <leastcost/problems/manifolds/file_places.hpp>
#include "problems/chart/chart_images.hpp"
#include "problems/formula/coordinate_names.hpp"

namespace leastcost {
namespace {

/// The places of all columns of `x`, whose pieces `site_of(i)` says.
template <class SiteOf>
void add_places(const HasFilePlaces& domain, SiteOf site_of, PathTable& table) {
  table.place_names = domain.place_columns();
  table.places.resize(static_cast<Index>(table.place_names.size()), table.x.cols());
  for (Index i = 0; i < table.x.cols(); ++i) table.places.col(i) = domain.place_in_file(site_of(i), table.x.col(i));
}

void append(const Points& columns, Index i, std::string& text) {
  if (columns.size() == 0) return;
  for (const double value : columns.col(i)) fmt::format_to(std::back_inserter(text), ",{:.17g}", value);
}

void accumulate(const Eigen::VectorXd& costs, PathTable& table) {
  const Index points = table.x.cols();
  table.segment_costs = Eigen::VectorXd::Zero(points);
  table.segment_costs.head(std::min(costs.size(), points)) = costs.head(std::min(costs.size(), points));
  table.cumulative_costs = Eigen::VectorXd::Zero(points);
  for (Index i = 1; i < points; ++i)
    table.cumulative_costs[i] = table.cumulative_costs[i - 1] + table.segment_costs[i - 1];
}

/// Points on the domain, without their costs.
PathTable table_of(const Problem& problem, const CoordinatePath& points) {
  PathTable table;
  table.x = positions(*problem.manifold, points);
  table.x_names = space_coordinates(*problem.manifold);
  if (const auto* chart = find_ability<HasChart>(*problem.manifold)) {
    const auto* images = find_ability<HasImages>(*problem.manifold);
    table.chart = images != nullptr ? continued(*images, points.u) : points.u;
    table.chart_names = chart->coordinate_names();
  }
  table.ring = points.ring;
  if (const auto* domain = find_ability<HasFilePlaces>(*problem.manifold))
    add_places(
        *domain, [&](Index i) { return points.site(i); }, table);
  return table;
}

}  // namespace

PathTable delivered_points(const Problem& problem, const Result& result) {
  PathTable table = table_of(problem, result.path);
  accumulate(result.curve_costs, table);
  return table;
}

PathTable delivered_curve(const Problem& problem, const Result& result) {
  PathTable table;
  table.x = result.curve.x;
  table.x_names = space_coordinates(*problem.manifold);
  const AmbientPath path{{table.x.data(), table.x.rows(), table.x.cols()}, {}, false};
  accumulate(segment_costs(*problem.cost, path), table);
  const std::vector<Site>& sites = table.segment_sites = result.curve.segment_sites;
  const auto* domain = find_ability<HasFilePlaces>(*problem.manifold);
  if (domain == nullptr || sites.empty()) return table;
  const Index last = static_cast<Index>(sites.size()) - 1;
  add_places(
      *domain, [&](Index i) { return sites[static_cast<std::size_t>(std::min(i, last))]; }, table);
  return table;
}

PathTable waypoint_table(const Problem& problem, const Waypoints& waypoints) {
  PathTable table = table_of(problem, waypoints.path);
  const Index moves = waypoints.path.segment_count();
  Eigen::VectorXd costs(moves);
  for (Index i = 0; i < moves; ++i)
    costs[i] = (i + 1 < waypoints.cost.size() ? waypoints.cost[i + 1] : waypoints.total) - waypoints.cost[i];
  accumulate(costs, table);
  table.cumulative_costs = waypoints.cost;
  if (problem.cost->traits().unit != "s") return table;
  table.place_names.emplace_back("time");
  table.places.conservativeResize(static_cast<Index>(table.place_names.size()), table.x.cols());
  table.places.bottomRows(1) = waypoints.cost.transpose();
  return table;
}

std::string csv_text(const PathTable& table) {
  std::vector<std::string> names = {"index"};
  const auto add = [&names](const std::vector<std::string>& more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  add(table.x_names);
  add(table.chart_names);
  add({"segment_cost", "cumulative_cost"});
  add(table.place_names);
  std::string text = fmt::format("{}\n", fmt::join(names, ","));
  for (Index i = 0; i < table.x.cols(); ++i) {
    text += std::to_string(i);
    append(table.x, i, text);
    append(table.chart, i, text);
    fmt::format_to(std::back_inserter(text), ",{:.17g},{:.17g}", table.segment_costs[i], table.cumulative_costs[i]);
    append(table.places, i, text);
    text += '\n';
  }
  return text;
}

std::string first_path_csv(const Problem& problem, const FirstPath& first) {
  const Points x = positions(*problem.manifold, first.path);
  const auto* chart = find_ability<HasChart>(*problem.manifold);
  std::vector<std::string> names = space_coordinates(*problem.manifold);
  if (chart != nullptr)
    for (std::string& name : chart->coordinate_names()) names.push_back(std::move(name));
  std::string text = fmt::format("index,{}\n", fmt::join(names, ","));
  for (Index i = 0; i < x.cols(); ++i) {
    text += std::to_string(i);
    append(x, i, text);
    if (chart != nullptr) append(first.path.u, i, text);
    text += '\n';
  }
  return text;
}

std::string residuals_csv(const Problem& problem, const PathTable& curve) {
  const ConstraintManifold& manifold = *problem.manifold;
  if (manifold.shape() == Shape::flat || find_ability<HasChart>(manifold) != nullptr) return "";
  const Index m = curve.x.cols() - 1;
  if (m < 1) return "";
  Points x(curve.x.rows(), 2 * m + 1);  // points and the middles after them
  for (Index i = 0; i < m; ++i) {
    x.col(2 * i) = curve.x.col(i);
    x.col(2 * i + 1) = (curve.x.col(i) + curve.x.col(i + 1)) / 2;
  }
  x.col(2 * m) = curve.x.col(m);
  // The pieces of the segments, where they are known: a mesh then searches its faces only where the curve leaves one.
  std::vector<Site> sites;
  if (!curve.segment_sites.empty()) {
    for (const Site site : curve.segment_sites) sites.insert(sites.end(), 2, site);
    sites.push_back(curve.segment_sites.back());
  }
  CoordinatePath moved{x, std::move(sites), true};
  const Projection projection = manifold.project(moved);
  Eigen::VectorXd off = (moved.u - x).colwise().norm();
  for (const Index failed : projection.failed) off[failed] = std::numeric_limits<double>::quiet_NaN();
  std::string text = "cumulative_cost,at_point,between\n";
  for (Index i = 0; i < m; ++i)
    fmt::format_to(std::back_inserter(text), "{:.17g},{:.17g},{:.17g}\n", curve.cumulative_costs[i], off[2 * i],
                   off[2 * i + 1]);
  return text + fmt::format("{:.17g},{:.17g},\n", curve.cumulative_costs[m], off[2 * m]);
}

std::string history_csv(const std::vector<Iteration>& history) {
  std::string text = "iteration,energy,cost_error,step,evaluations,seconds\n";
  for (const Iteration& i : history)
    fmt::format_to(std::back_inserter(text), "{},{:.17g},{:.17g},{:.17g},{},{:.6f}\n", i.iteration, i.energy,
                   i.cost_error, i.step, i.evaluations, i.seconds);
  return text;
}

}  // namespace leastcost
