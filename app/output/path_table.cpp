// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/output/path_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "framework/path_energy.hpp"
#include "problems/geometry/coordinate_names.hpp"
#include "problems/geometry/has_mesh.hpp"
#include "problems/geometry/path_tools.hpp"

namespace leastcost::app {
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

std::string history_csv(const std::vector<Iteration>& history) {
  std::string text = "iteration,energy,cost_error,step,evaluations,seconds\n";
  for (const Iteration& i : history)
    fmt::format_to(std::back_inserter(text), "{},{:.17g},{:.17g},{:.17g},{},{:.6f}\n", i.iteration, i.energy,
                   i.cost_error, i.step, i.evaluations, i.seconds);
  return text;
}

}  // namespace leastcost::app
