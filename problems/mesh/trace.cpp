// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/trace.hpp"

#include <optional>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include "problems/mesh/surface_walk.hpp"

namespace leastcost {
namespace {

constexpr double kLongestSection = 10;  // chords: a section this long has gone somewhere else

class ChainTracer {
 public:
  ChainTracer(const TriangleMesh& mesh, const Deadline& deadline) : mesh_(mesh), deadline_(deadline) {}

  TracedPath trace(std::span<const SurfacePoint> chain) {
    TracedPath result;
    if (chain.empty()) return result;
    Place here = place_of(mesh_, chain.front());
    result.path.points.push_back(here.position);
    result.chain_points.push_back(0);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      look_at_clock(deadline_);
      const Place next = place_of(mesh_, chain[i]);
      bring_to(here, next, result);
      result.chain_points.push_back(result.path.points.size() - 1);
      here = next;
    }
    return result;
  }

 private:
  /// Appends the way from a, where the path ends, to b.
  void bring_to(const Place& a, const Place& b, TracedPath& result) {
    SurfacePath& path = result.path;
    const std::int32_t face = common_face_of(mesh_, a, b);
    if (face >= 0) {
      append_point(path, b.position, face);
      ++result.report.direct;
      return;
    }
    const std::size_t points = path.points.size();
    if (walk_towards(mesh_, a, b, path)) {
      ++result.report.walked;
      return;
    }
    path.points.resize(points);
    path.faces.resize(points - 1);
    if (follow_section(mesh_, a, b, kLongestSection * (b.position - a.position).norm(), path)) {
      ++result.report.cut;
      return;
    }
    connect(a, b, path);
    ++result.report.connected;
  }

  void connect(const Place& a, const Place& b, SurfacePath& path) {
    if (!graph_) graph_.emplace(mesh_);
    EdgePathOptions options;
    options.lower_bound = [&b](const Eigen::Vector3d& p) { return (p - b.position).norm(); };
    const auto length = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return (q - p).norm(); };
    if (deadline_) options.stop = [this] { return deadline_.has_ended(); };
    const EdgePath edges = graph_->shortest(a.where, b.where, length, options);
    if (edges.outcome == EdgePathOutcome::stopped) throw Interrupted(edges.failure());
    if (!edges.found()) throw InputError("tracing: no path on the mesh between two points: " + edges.failure());
    for (std::size_t i = 0; i < edges.path.faces.size(); ++i)
      append_point(path, edges.path.points[i + 1], edges.path.faces[i]);
  }

  const TriangleMesh& mesh_;
  const Deadline& deadline_;
  std::optional<EdgeGraphSearch> graph_;
};

}  // namespace

TracedPath trace_chain(const TriangleMesh& mesh, std::span<const SurfacePoint> chain, const Deadline& deadline) {
  return ChainTracer(mesh, deadline).trace(chain);
}

}  // namespace leastcost
