// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/post_processors/straighten.hpp"

#include <string>
#include <utility>

#include "framework/errors.hpp"
#include "problems/geometry/mesh_curve.hpp"
#include "problems/geometry/straighten.hpp"
#include "problems/geometry/trace.hpp"

namespace leastcost {
namespace {

/// The curve as it was traced, or a fresh trace where no post-processor has made one.
SurfacePath on_surface(const TriangleMesh& mesh, const PostProcessed& current) {
  if (!current.curve.segment_sites.empty()) return as_surface_path(current.curve);
  return trace_chain(mesh, surface_points(mesh, current.chain)).path;
}

}  // namespace

PostProcessed StraightenPostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                             const Monitor& monitor) const {
  const TriangleMesh& mesh = mesh_of(problem, "post-processor straighten").mesh();
  const std::optional<MetricRoot> metric = constant_metric(problem);
  if (!metric)
    throw InputError(
        "straighten unfolds the mesh, which needs a cost with a constant metric (euclidean, metric_tensor)");
  if (current.chain.ring) throw InputError("straighten works on open paths; this path is a ring");
  StraightenOptions options{.metric = *metric, .stop = [&monitor] { return monitor.interrupted(); }, .flips = true};
  const SurfacePath start = trace_chain(mesh, surface_points(mesh, first.path)).path;
  Straightened best = straighten(mesh, start, options);
  Straightened solved = straighten(mesh, on_surface(mesh, current), options);
  // The solve may have slid into a longer class: its result is kept only where it is no longer than the first path's.
  const bool keep_solved = solved.final_length <= best.final_length;
  if (!keep_solved)
    current.notes.emplace_back("straighten: the first path gave a shorter path than the solved one");
  else
    best = std::move(solved);
  current.curve = as_curve(problem, best.path);
  current.curve.straightness = check_straight(mesh, best.path, *metric);
  const Index columns = current.chain.u.cols();
  current.chain = coordinate_path(mesh, resample(mesh, best.path, static_cast<int>(columns), *metric));
  pin_ends(problem, current.chain);
  current.curve_costs = costs_along(problem, current.curve, current.chain);
  if (!best.finished) current.notes.emplace_back("straighten: interrupted before the path was straight");
  return current;
}

}  // namespace leastcost
