// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/straighten.hpp>

#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "problems/mesh/mesh_curve.hpp"
#include "problems/mesh/trace.hpp"
#include "problems/straighten/straighten_ring.hpp"

namespace leastcost {
namespace {

/// A chain as a polyline on the mesh; a ring ends where it begins.
SurfacePath traced(const TriangleMesh& mesh, const CoordinatePath& chain, const Deadline& deadline) {
  std::vector<SurfacePoint> points = surface_points(mesh, chain);
  if (chain.ring) points.push_back(points.front());
  return trace_chain(mesh, points, deadline).path;
}

/// The curve as it was traced, or a fresh trace where no post-processor has made one.
SurfacePath on_surface(const TriangleMesh& mesh, const PostProcessed& current, const Deadline& deadline) {
  if (!current.curve.segment_sites.empty()) return as_surface_path(current.curve);
  return traced(mesh, current.chain, deadline);
}

/// What straightening made of the better of two paths.
struct Outcome {
  SurfacePath path;
  bool finished = true;
  bool collapsed = false;
  const char* note = nullptr;  ///< where the solved path was not taken
};

/// The solve may have slid into a longer class: its result is kept only where it is no longer than the first path's. Of
/// a loop with a fixed point (`based`) nothing may be left: see straighten_closed().
Outcome straighten_open(const TriangleMesh& mesh, const SurfacePath& first, const SurfacePath& solved, bool based,
                        const StraightenOptions& options) {
  constexpr double kNothing = 1e-9;  // of the first loop
  Straightened a = straighten(mesh, first, options), b = straighten(mesh, solved, options);
  const double nothing = based ? kNothing * path_length(first, options.metric) : 0;
  if (based && b.final_length <= nothing) {
    if (a.final_length <= nothing) return {std::move(b.path), b.finished, true};
    return {std::move(a.path), a.finished, false, "straighten: the solved loop contracts; the first loop is used"};
  }
  if (based && a.final_length <= nothing) return {std::move(b.path), b.finished};
  if (a.final_length < b.final_length)
    return {std::move(a.path), a.finished, false, "straighten: the first path gave a shorter path than the solved one"};
  return {std::move(b.path), b.finished};
}

/// Nor is a solved ring kept that contracts while the first one does not: with few points a chain jumps over what holds
/// it. One that is shorter is kept, even much: straightening alone stops in every dent of a noisy mesh.
Outcome straighten_closed(const TriangleMesh& mesh, const SurfacePath& first, const SurfacePath& solved,
                          const StraightenOptions& options) {
  StraightenedRing a = straighten_ring(mesh, first, options), b = straighten_ring(mesh, solved, options);
  if (!a.collapsed && b.collapsed)
    return {std::move(a.path), a.finished, false, "straighten: the solved ring contracts; the first ring is used"};
  if (!a.collapsed && a.final_length < b.final_length)
    return {std::move(a.path), a.finished, false, "straighten: the first ring gave a shorter ring than the solved one"};
  return {std::move(b.path), b.finished, b.collapsed};
}

/// `columns` points of the path, equally spaced by length; a ring has no point twice.
CoordinatePath spaced(const Problem& problem, const TriangleMesh& mesh, const SurfacePath& path, bool ring, int columns,
                      const MetricRoot& metric) {
  std::vector<SurfacePoint> points = resample(mesh, path, ring ? columns + 1 : columns, metric);
  if (ring) points.pop_back();
  CoordinatePath chain = coordinate_path(problem, mesh, points);
  chain.ring = ring;
  return chain;
}

/// The path given, where there is no other.
Outcome straighten_one(const TriangleMesh& mesh, const SurfacePath& path, bool based,
                       const StraightenOptions& options) {
  constexpr double kNothing = 1e-9;  // of the loop given
  Straightened straight = straighten(mesh, path, options);
  const bool collapsed = based && straight.final_length <= kNothing * straight.initial_length;
  return {std::move(straight.path), straight.finished, collapsed};
}

}  // namespace

PostProcessed StraightenPostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                             const Monitor& monitor) const {
  const TriangleMesh& mesh = mesh_of(problem, "post-processor straighten").mesh();
  const std::optional<MetricRoot> metric = constant_metric(problem);
  if (!metric)
    throw InputError(
        "straighten unfolds the mesh, which needs a cost with a constant metric (euclidean, metric_tensor)");
  const StraightenOptions options{
      .metric = *metric, .stop = [&monitor] { return monitor.interrupted(); }, .flips = true};
  const bool ring = current.chain.ring;
  const auto straightened = [&] {
    if (current.unsolved && !ring)
      return straighten_one(mesh, on_surface(mesh, current, monitor.deadline), problem.based, options);
    const SurfacePath start = traced(mesh, first.path, monitor.deadline);
    const SurfacePath solved = on_surface(mesh, current, monitor.deadline);
    return ring ? straighten_closed(mesh, start, solved, options)
                : straighten_open(mesh, start, solved, problem.based, options);
  };
  const Outcome best = straightened();
  if (best.collapsed) {
    current.collapsed = true;
    current.notes.emplace_back("straighten: the ring contracts to a point of the mesh");
    return current;
  }
  if (best.note != nullptr) current.notes.emplace_back(best.note);
  current.curve = as_curve(problem, best.path);
  current.curve.straightness =
      ring ? check_straight_ring(mesh, best.path, *metric) : check_straight(mesh, best.path, *metric);
  current.chain = spaced(problem, mesh, best.path, ring, static_cast<int>(current.chain.u.cols()), *metric);
  pin_ends(problem, current.chain);
  current.curve_costs = costs_along(problem, current.curve, current.chain);
  if (!best.finished) current.notes.emplace_back("straighten: interrupted before the path was straight");
  return current;
}

}  // namespace leastcost
