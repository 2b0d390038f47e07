// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/edge_path.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/mesh/slot_queue.hpp"

namespace leastcost {

/// Where an edge e is crossed straight from a to b in the unfolding of its two faces; all seen from its tail.
struct UnfoldedCrossing {
  double at = 0;       ///< from tail (0) to head (1), strictly between them
  double squared = 0;  ///< |e|^2
  double along = 0;    ///< (b - a) . e
  double depth = 0;    ///< |e| times the sum of the heights of a and b
};

inline std::optional<UnfoldedCrossing> unfolded_crossing(const Eigen::Vector3d& e, const Eigen::Vector3d& a,
                                                         const Eigen::Vector3d& b) {
  const double squared = e.squaredNorm(), along_a = a.dot(e), along_b = b.dot(e);
  const double height_a = e.cross(a).norm(), height_b = e.cross(b).norm(), depth = height_a + height_b;
  if (!(squared > 0) || !(depth > 0)) return std::nullopt;
  const double at = (along_a * height_b + along_b * height_a) / (squared * depth);
  if (!(at > 0) || !(at < 1)) return std::nullopt;
  return UnfoldedCrossing{at, squared, along_b - along_a, depth};
}

/// A move from one vertex straight across an edge to another.
struct DiagonalMove {
  double cost = std::numeric_limits<double>::infinity();
  double at = 0;  ///< of the crossing, from tail (0) to head (1) of the edge
};

/// The far side of each face at a vertex, and the third corner behind it: visit(halfedge, vertex).
template <class Visit>
void for_diagonals(const TriangleMesh& mesh, std::int32_t vertex, Visit visit) {
  for (const std::int32_t f : mesh.faces_of_vertex(vertex)) {
    const std::array<std::int32_t, 3>& c = mesh.face(f);
    const std::int32_t h = 3 * f + (c[0] == vertex ? 1 : c[1] == vertex ? 2 : 0), other = mesh.across(h);
    if (other >= 0) visit(h, mesh.tail(TriangleMesh::previous(other)));
  }
}

template <class Cost>
DiagonalMove move_across(const TriangleMesh& mesh, const Cost& cost, const Eigen::Vector3d& from, std::int32_t halfedge,
                         std::int32_t to) {
  return cost.across(from, mesh.position(mesh.tail(halfedge)), mesh.position(mesh.head(halfedge)), mesh.position(to));
}

/// The path that moves between nodes make: vertices, and (numbered behind them) a source and a target that are none.
template <class Cost>
struct MoveTracer {
  const TriangleMesh& mesh;
  const Cost& cost;
  bool diagonals;
  const SurfacePoint &source, &target;

  /// From node to node, from the source to the target.
  SurfacePath path(const std::vector<std::int32_t>& nodes) const {
    SurfacePath path;
    path.points.push_back(position(nodes.front()));
    for (std::size_t i = 1; i < nodes.size(); ++i) append_move(nodes[i - 1], nodes[i], path);
    return path;
  }

 private:
  using Vector = Eigen::Vector3d;

  bool is_vertex(std::int32_t node) const { return node < mesh.vertex_count(); }
  Vector position(std::int32_t node) const {
    if (is_vertex(node)) return mesh.position(node);
    return mesh.point(node == mesh.vertex_count() ? source : target);
  }

  std::int32_t face_with_both(std::int32_t a, std::int32_t b) const {
    for (const std::int32_t f : mesh.faces_of_vertex(a)) {
      const std::array<std::int32_t, 3>& c = mesh.face(f);
      if (std::find(c.begin(), c.end(), b) != c.end()) return f;
    }
    return -1;
  }

  /// Appends the piece from -> to: through the edge that it crosses where that is cheaper.
  void append_move(std::int32_t from, std::int32_t to, SurfacePath& path) const {
    const Vector a = position(from), b = position(to);
    const auto add = [&path](const Vector& p, std::int32_t face) {
      path.points.push_back(p);
      path.faces.push_back(face);
    };
    if (!is_vertex(from)) return add(b, source.face);
    if (!is_vertex(to)) return add(b, target.face);
    const std::int32_t face = face_with_both(from, to);
    double best = face >= 0 ? cost(a, b) : std::numeric_limits<double>::infinity(), at = 0;
    std::int32_t door = -1;
    if (diagonals)
      for_diagonals(mesh, from, [&](std::int32_t halfedge, std::int32_t opposite) {
        if (opposite != to) return;
        const DiagonalMove diagonal = move_across(mesh, cost, a, halfedge, to);
        if (!(diagonal.cost < best)) return;
        best = diagonal.cost;
        door = halfedge;
        at = diagonal.at;
      });
    if (door < 0) return add(b, face);
    const Vector& tail = mesh.position(mesh.tail(door));
    add(tail + at * (mesh.position(mesh.head(door)) - tail), door / 3);
    add(b, mesh.across(door) / 3);
  }
};

/// The cheapest paths along the edges of a mesh, and straight across them: A* on one heap. Its nodes are the vertices
/// and up to two ends that are none. Keeps its memory between queries, so that a query costs what it visits and not the
/// size of the mesh. What moves cost it is told by a
///
///     struct Cost {
///       static constexpr int kLookEvery = 256;        // settled nodes between two questions to the stop predicate
///       double operator()(a, b) const;                // of a straight move, >= 0; +infinity: not passable
///       bool may_be_below(a, b, limit) const;         // whether a move from a to b may cost less; as quickly as can
///       be DiagonalMove across(a, tail, head, b) const;  // from a to b across the edge from tail to head void
///       aim(goal, vertices);                     // the place of the target, and the vertices that it is beside double
///       rest(node, x) const;                   // lower bound from a node at x to the target; aimed at or not
///     };
template <class Cost>
class EdgeSearch {
 public:
  explicit EdgeSearch(const TriangleMesh& mesh)
      : mesh_(&mesh), records_(static_cast<Record*>(std::calloc(record_count(), sizeof(Record)))) {
    if (!records_) throw std::bad_alloc();
  }

  /// An end at a vertex is that vertex; any other end is connected to the corners of its face, and straight to the
  /// other end where both lie on one face.
  EdgePath shortest(const SurfacePoint& source, const SurfacePoint& target, Cost cost, bool diagonals,
                    const StopPredicate& stop) {
    EdgePath result;
    const std::int32_t from = mesh_->component(mesh_->face(source.face)[0]);
    const std::int32_t to = mesh_->component(mesh_->face(target.face)[0]);
    result.source_component_size = mesh_->component_sizes()[static_cast<std::size_t>(from)];
    result.target_component_size = mesh_->component_sizes()[static_cast<std::size_t>(to)];
    if (from != to) {
      result.outcome = EdgePathOutcome::different_components;
      return result;
    }
    begin(cost, diagonals, stop);
    aim(source, target, cost);
    result.outcome = run();
    result.settled = settled_;
    if (!result.found()) return result;
    result.cost = record(target_).cost;
    result.path = path_found(result.vertices);
    return result;
  }

 private:
  using Vector = Eigen::Vector3d;

  /// Valid when its stamp is that of the query, so that nothing is ever cleared.
  struct Record {
    std::uint32_t stamp = 0;
    std::int32_t predecessor = -1;
    double cost = std::numeric_limits<double>::infinity();
    double rest = 0;  // lower bound to the target, from when the node was first reached
  };
  struct Free {
    void operator()(Record* records) const { std::free(records); }
  };

  std::size_t record_count() const { return static_cast<std::size_t>(mesh_->vertex_count()) + 2; }
  bool is_vertex(std::int32_t node) const { return node < mesh_->vertex_count(); }
  Vector position(std::int32_t node) const {
    if (is_vertex(node)) return mesh_->position(node);
    return mesh_->point(node == mesh_->vertex_count() ? source_point_ : target_point_);
  }
  Record& record(std::int32_t node) {
    Record& r = records_[static_cast<std::size_t>(node)];
    if (r.stamp != stamp_) r = Record{.stamp = stamp_, .predecessor = node};
    return r;
  }

  void begin(const Cost& cost, bool diagonals, const StopPredicate& stop) {
    if (++stamp_ == 0) {  // wrapped around after four thousand million queries
      std::fill_n(records_.get(), record_count(), Record{});
      stamp_ = 1;
    }
    cost_ = &cost;
    diagonals_ = diagonals;
    stop_ = &stop;
    open_.clear();
    target_corners_ = {-1, -1, -1};
    settled_ = 0;
  }

  void aim(const SurfacePoint& source, const SurfacePoint& target, Cost& cost) {
    source_point_ = source;
    target_point_ = target;
    const std::int32_t s = vertex_at(*mesh_, source), t = vertex_at(*mesh_, target);
    source_ = s >= 0 ? s : mesh_->vertex_count();
    target_ = t >= 0 ? t : mesh_->vertex_count() + 1;
    if (t < 0) target_corners_ = mesh_->face(target.face);
    cost.aim(position(target_),
             t < 0 ? std::span<const std::int32_t>(target_corners_) : std::span<const std::int32_t>(&target_, 1));
  }

  EdgePathOutcome run() {
    Record& first = record(source_);
    first.cost = 0;
    first.rest = cost_->rest(source_, position(source_));
    open_.push({first.rest, source_});
    while (!open_.empty()) {
      const OpenNode next = open_.pop();
      const Record& r = record(next.node);
      if (next.key > r.cost + r.rest) continue;  // a cheaper way was found since
      if (next.node == target_) return EdgePathOutcome::found;
      if (++settled_ % Cost::kLookEvery == 0 && *stop_ && (*stop_)()) return EdgePathOutcome::stopped;
      if (!open_.empty() && is_vertex(open_.top().node)) __builtin_prefetch(mesh_->neighbours(open_.top().node).data());
      leave(next.node);
    }
    return EdgePathOutcome::no_finite_route;
  }

  void relax(std::int32_t from, Record& r, std::int32_t to, const Vector& there, double cost) {
    if (!(cost < r.cost)) return;
    if (r.cost == std::numeric_limits<double>::infinity()) r.rest = cost_->rest(to, there);
    r.cost = cost;
    r.predecessor = from;
    open_.push({cost + r.rest, to});
  }

  void go(std::int32_t from, const Vector& here, double so_far, std::int32_t to) {
    Record& r = record(to);
    const double gain = r.cost - so_far;
    if (!(gain > 0)) return;
    const Vector there = position(to);
    if (cost_->may_be_below(here, there, gain)) relax(from, r, to, there, so_far + (*cost_)(here, there));
  }

  void leave(std::int32_t node) {
    const Vector here = position(node);
    const double so_far = record(node).cost;
    if (!is_vertex(node)) {  // the source, inside a face
      for (const std::int32_t corner : mesh_->face(source_point_.face)) go(node, here, so_far, corner);
      if (!is_vertex(target_) && target_point_.face == source_point_.face) go(node, here, so_far, target_);
      return;
    }
    const std::span<const std::int32_t> beside = mesh_->neighbours(node);
    for (const std::int32_t to : beside) {  // memory is what a search on a large mesh waits for
      __builtin_prefetch(&records_[static_cast<std::size_t>(to)]);
      __builtin_prefetch(&mesh_->position(to));
    }
    for (const std::int32_t to : beside) go(node, here, so_far, to);
    if (diagonals_) leave_across(node, here, so_far);
    if (std::find(target_corners_.begin(), target_corners_.end(), node) != target_corners_.end())
      go(node, here, so_far, target_);
  }

  /// Most moves make nothing cheaper, which is found out before they are made.
  void leave_across(std::int32_t node, const Vector& here, double so_far) {
    for_diagonals(*mesh_, node, [&](std::int32_t halfedge, std::int32_t to) {
      Record& r = record(to);
      const double gain = r.cost - so_far;
      const Vector& there = mesh_->position(to);
      if (gain > 0 && to != node && cost_->may_be_below(here, there, gain))
        relax(node, r, to, there, so_far + move_across(*mesh_, *cost_, here, halfedge, to).cost);
    });
  }

  SurfacePath path_found(std::vector<std::int32_t>& vertices) const {
    std::vector<std::int32_t> nodes{target_};
    while (nodes.back() != source_) nodes.push_back(records_[static_cast<std::size_t>(nodes.back())].predecessor);
    std::reverse(nodes.begin(), nodes.end());
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(vertices),
                 [this](std::int32_t n) { return is_vertex(n); });
    return MoveTracer<Cost>{*mesh_, *cost_, diagonals_, source_point_, target_point_}.path(nodes);
  }

  const TriangleMesh* mesh_;
  const Cost* cost_ = nullptr;
  const StopPredicate* stop_ = nullptr;
  bool diagonals_ = false;
  std::int32_t source_ = -1, target_ = -1;
  SurfacePoint source_point_, target_point_;
  std::array<std::int32_t, 3> target_corners_{-1, -1, -1};  // where the target is no vertex
  /// Zeros, which are stale: only the pages of nodes that a search meets are ever touched, so that making and freeing
  /// it takes no time on a mesh of a million vertices.
  std::unique_ptr<Record[], Free> records_;
  OpenHeap open_;
  std::uint32_t stamp_ = 0;
  std::int32_t settled_ = 0;
};

}  // namespace leastcost
