// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/trace.hpp>

#include <algorithm>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "problems/mesh/mesh_curve.hpp"
#include "problems/mesh/trace.hpp"

namespace leastcost {
namespace {

/// Cost of the curve between consecutive points of the chain.
Eigen::VectorXd costs_between(const Problem& problem, const Curve& curve,
                              const std::vector<std::size_t>& chain_points) {
  const Eigen::VectorXd pieces =
      segment_costs(*problem.cost, {{curve.x.data(), curve.x.rows(), curve.x.cols()}, {}, false});
  Eigen::VectorXd costs(static_cast<Index>(chain_points.size()) - 1);
  for (Index i = 0; i < costs.size(); ++i) {
    const auto begin = static_cast<Index>(chain_points[static_cast<std::size_t>(i)]);
    const auto end = static_cast<Index>(chain_points[static_cast<std::size_t>(i) + 1]);
    costs[i] = pieces.segment(begin, end - begin).sum();
  }
  return costs;
}

SurfacePath part_of(const SurfacePath& path, std::size_t begin, std::size_t end) {
  const auto at = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
  return {{path.points.begin() + at(begin), path.points.begin() + at(end) + 1},
          {path.faces.begin() + at(begin), path.faces.begin() + at(end)}};
}

double cost_of(const Problem& problem, const SurfacePath& path) {
  const int rows = problem.manifold->dimensions().ambient;
  Points x(rows, static_cast<Index>(path.points.size()));
  for (std::size_t i = 0; i < path.points.size(); ++i) x.col(static_cast<Index>(i)) = path.points[i].head(rows);
  return total_cost(*problem.cost, {{x.data(), rows, x.cols()}, {}, false});
}

/// The way between two points of the chain pulled straight, where that is cheaper. Under a metric that varies no
/// post-processor straightens the whole curve, and a plane cuts a fold of the mesh far from the shortest way across it.
SurfacePath pulled_straight(const Problem& problem, const TriangleMesh& mesh, SurfacePath way, const Monitor& monitor) {
  if (way.faces.size() < 2) return way;
  try {
    const StraightenOptions options{.stop = [&monitor] { return monitor.interrupted(); }};
    SurfacePath straight = straighten(mesh, way, options).path;
    straight.points.front() = way.points.front();
    straight.points.back() = way.points.back();
    if (cost_of(problem, straight) < cost_of(problem, way)) return straight;
  } catch (const InputError&) {  // an edge of three faces: the way stays
  }
  return way;
}

/// The same of every way between two points of the chain.
void pull_straight(const Problem& problem, const TriangleMesh& mesh, const Monitor& monitor, TracedPath& traced) {
  TracedPath out;
  out.report = traced.report;
  out.path.points.push_back(traced.path.points.front());
  out.chain_points.push_back(0);
  for (std::size_t i = 0; i + 1 < traced.chain_points.size(); ++i) {
    look_at_clock(monitor.deadline);
    const SurfacePath way = pulled_straight(
        problem, mesh, part_of(traced.path, traced.chain_points[i], traced.chain_points[i + 1]), monitor);
    out.path.points.insert(out.path.points.end(), way.points.begin() + 1, way.points.end());
    out.path.faces.insert(out.path.faces.end(), way.faces.begin(), way.faces.end());
    out.chain_points.push_back(out.path.points.size() - 1);
  }
  traced = std::move(out);
}

/// A chain that slid onto another component of the mesh cannot be traced: the first path takes its place.
bool leaves_component(const TriangleMesh& mesh, const std::vector<SurfacePoint>& points) {
  const auto component = [&mesh](const SurfacePoint& p) { return mesh.component(mesh.face(p.face)[0]); };
  return std::any_of(points.begin(), points.end(),
                     [&](const SurfacePoint& p) { return component(p) != component(points.front()); });
}

}  // namespace

PostProcessed TracePostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                        const Monitor& monitor) const {
  const TriangleMesh& mesh = mesh_of(problem, "post-processor trace").mesh();
  std::vector<SurfacePoint> points = surface_points(mesh, current.chain);
  if (current.curve.straightness) return current;  // it lies on the mesh already
  const bool ring = current.chain.ring;
  if (current.unsolved && !ring) {  // the points lie on the first path: that is the curve
    current.curve = as_curve(problem, trace_chain(mesh, surface_points(mesh, first.path), monitor.deadline).path);
    current.curve_costs = costs_along(problem, current.curve, current.chain);
    return current;
  }
  if (leaves_component(mesh, points)) {
    std::vector<SurfacePoint> start = surface_points(mesh, first.path);
    if (ring) start.push_back(start.front());
    points = resample(mesh, trace_chain(mesh, start, monitor.deadline).path,
                      static_cast<int>(points.size()) + (ring ? 1 : 0));
    if (ring) points.pop_back();
    current.chain = coordinate_path(problem, mesh, points);
    current.chain.ring = ring;
    pin_ends(problem, current.chain);
    current.notes.emplace_back(
        "trace: the solved path slid onto another component of the mesh; the first path is used");
  }
  if (ring) points.push_back(points.front());
  TracedPath traced = trace_chain(mesh, points, monitor.deadline);
  if (!constant_metric(problem)) pull_straight(problem, mesh, monitor, traced);
  current.curve = as_curve(problem, traced.path);
  current.curve_costs = costs_between(problem, current.curve, traced.chain_points);
  if (traced.report.cut + traced.report.connected > 0)
    current.notes.push_back("trace: " + std::to_string(traced.report.cut) + " segments by cutting plane, " +
                            std::to_string(traced.report.connected) + " by edge path");
  return current;
}

}  // namespace leastcost
