// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/path_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include <leastcost/framework/path_energy.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include "problems/formula/coordinate_names.hpp"

namespace leastcost {
namespace {

const TriangleMesh* mesh_of(const Problem& problem) {
  const auto* domain = dynamic_cast<const HasMesh*>(problem.manifold.get());
  return domain == nullptr ? nullptr : &domain->mesh();
}

TriangleMesh::FilePoint file_point(const TriangleMesh& mesh, Site site, const Eigen::VectorXd& x) {
  if (site < 0) return {};
  return mesh.in_file(point_on_face(mesh, site, x));
}

void accumulate(const Eigen::VectorXd& costs, PathTable& table) {
  const Index points = table.x.cols();
  table.segment_costs = Eigen::VectorXd::Zero(points);
  table.segment_costs.head(std::min(costs.size(), points)) = costs.head(std::min(costs.size(), points));
  table.cumulative_costs = Eigen::VectorXd::Zero(points);
  for (Index i = 1; i < points; ++i)
    table.cumulative_costs[i] = table.cumulative_costs[i - 1] + table.segment_costs[i - 1];
}

}  // namespace

PathTable delivered_points(const Problem& problem, const Result& result) {
  PathTable table;
  // A ring's ambient path repeats its first point at the end.
  PathEnergy energy(problem, 1);
  table.x = energy.ambient(result.path).x.leftCols(result.path.u.cols());
  if (dynamic_cast<const HasChart*>(problem.manifold.get())) table.chart = result.path.u;
  table.ring = result.path.ring;
  accumulate(result.curve_costs, table);
  if (const TriangleMesh* mesh = mesh_of(problem)) {
    for (Index i = 0; i < table.x.cols(); ++i)
      table.on_mesh.push_back(file_point(*mesh, result.path.site(i), table.x.col(i)));
  }
  return table;
}

PathTable delivered_curve(const Problem& problem, const Result& result) {
  PathTable table;
  table.x = result.curve.x;
  const AmbientPath path{{table.x.data(), table.x.rows(), table.x.cols()}, {}, false};
  accumulate(segment_costs(*problem.cost, path), table);
  const TriangleMesh* mesh = mesh_of(problem);
  const std::vector<Site>& sites = result.curve.segment_sites;
  if (mesh == nullptr || sites.empty()) return table;
  for (Index i = 0; i < table.x.cols(); ++i) {
    const auto segment = static_cast<std::size_t>(std::min(i, static_cast<Index>(sites.size()) - 1));
    table.on_mesh.push_back(file_point(*mesh, sites[segment], table.x.col(i)));
  }
  return table;
}

std::string csv_text(const PathTable& table) {
  std::vector<std::string> names = coordinate_names(static_cast<int>(table.x.rows()));
  if (table.chart.size() > 0) names.insert(names.end(), {"u", "v"});
  std::string text = fmt::format("index,{},segment_cost,cumulative_cost", fmt::join(names, ","));
  text += table.on_mesh.empty() ? "\n" : ",face,fan,v0,v1,v2,b0,b1,b2\n";
  const auto out = std::back_inserter(text);
  for (Index i = 0; i < table.x.cols(); ++i) {
    fmt::format_to(out, "{}", i);
    for (const double coordinate : table.x.col(i)) fmt::format_to(out, ",{:.17g}", coordinate);
    if (table.chart.size() > 0)
      for (const double coordinate : table.chart.col(i)) fmt::format_to(out, ",{:.17g}", coordinate);
    fmt::format_to(out, ",{:.17g},{:.17g}", table.segment_costs[i], table.cumulative_costs[i]);
    if (!table.on_mesh.empty()) {
      const TriangleMesh::FilePoint& p = table.on_mesh[static_cast<std::size_t>(i)];
      fmt::format_to(out, ",{},{},{}", p.face, p.fan, fmt::join(p.vertices, ","));
      for (const double weight : p.barycentric) fmt::format_to(out, ",{:.17g}", weight);
    }
    text += '\n';
  }
  return text;
}

std::string first_path_csv(const Problem& problem, const FirstPath& first) {
  const Points x = positions(*problem.manifold, first.path);
  const bool chart = dynamic_cast<const HasChart*>(problem.manifold.get()) != nullptr;
  std::string text =
      fmt::format("index,{}{}\n", fmt::join(coordinate_names(static_cast<int>(x.rows())), ","), chart ? ",u,v" : "");
  const auto out = std::back_inserter(text);
  for (Index i = 0; i < x.cols(); ++i) {
    fmt::format_to(out, "{}", i);
    for (const double coordinate : x.col(i)) fmt::format_to(out, ",{:.17g}", coordinate);
    if (chart)
      for (const double coordinate : first.path.u.col(i)) fmt::format_to(out, ",{:.17g}", coordinate);
    text += '\n';
  }
  return text;
}

std::string residuals_csv(const Problem& problem, const PathTable& curve) {
  const ConstraintManifold& manifold = *problem.manifold;
  if (manifold.shape() == Shape::flat || dynamic_cast<const HasChart*>(&manifold) != nullptr) return "";
  const Index m = curve.x.cols() - 1;
  if (m < 1) return "";
  Points x(curve.x.rows(), 2 * m + 1);  // points and the middles after them
  for (Index i = 0; i < m; ++i) {
    x.col(2 * i) = curve.x.col(i);
    x.col(2 * i + 1) = (curve.x.col(i) + curve.x.col(i + 1)) / 2;
  }
  x.col(2 * m) = curve.x.col(m);
  CoordinatePath moved{x, {}, true};
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
