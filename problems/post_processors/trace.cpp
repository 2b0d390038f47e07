// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/trace.hpp>

#include <algorithm>
#include <string>
#include <utility>

#include <leastcost/framework/errors.hpp>
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
        "trace: the solved path slid onto another component of the mesh; the first path is taken");
  }
  if (ring) points.push_back(points.front());
  const TracedPath traced = trace_chain(mesh, points, monitor.deadline);
  current.curve = as_curve(problem, traced.path);
  current.curve_costs = costs_between(problem, current.curve, traced.chain_points);
  if (traced.report.cut + traced.report.connected > 0)
    current.notes.push_back("trace: " + std::to_string(traced.report.cut) + " segments by cutting plane, " +
                            std::to_string(traced.report.connected) + " by edge path");
  return current;
}

}  // namespace leastcost
