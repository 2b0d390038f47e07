// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "problems/exact/end_point.hpp"
#include "problems/exact/forks.hpp"
#include "problems/exact/half_edges.hpp"
#include "problems/exact/large_pages.hpp"
#include "problems/exact/lower_bound.hpp"
#include "problems/exact/propagation_parts.hpp"
#include "problems/exact/sliver_table.hpp"
#include "problems/exact/window.hpp"
#include "problems/exact/window_queue.hpp"

namespace leastcost {

/// Windows from a source over the surface in the order of their keys: what the paths through them cost at least, with
/// what is left to the target. docs/numerics.md Sec. 5.4 says why every shortest path stays within some window,
/// whatever rounding does. Reusable: keeps its memory. One object per thread.
template <class Real>
class Propagation {
 public:
  explicit Propagation(const HalfEdges& mesh);

  /// Runs until nothing open can beat the best path by more than the slack. Without a target: until all is reached.
  void run(const EndPoint& source, const EndPoint* target, const LowerBound& bound, const QueryLimits& limits) {
    run({&source, 1}, target, bound, limits);
  }
  /// The same from the nearest of several sources, at least one. With more than one no path can be traced.
  void run(std::span<const EndPoint> sources, const EndPoint* target, const LowerBound& bound,
           const QueryLimits& limits);

  /// No path to the target is shorter, whatever stopped the run; infinite where there is none.
  double lower_bound() const;
  /// There is a path to the target that is at most this long: the found one; infinite where none was found.
  double found() const { return target_at_most_; }
  /// Paths that could be shorter than the best run over a face without height.
  bool blocked() const { return blocked_ < limit_; }
  /// Of these, some because more windows came to one edge than are taken.
  bool crowded() const { return crowded_ < limit_; }
  /// The budget was spent, or somebody asked to stop.
  bool stopped() const { return stopped_; }
  /// That it was the memory.
  bool out_of_memory() const { return out_of_memory_; }
  /// Without a target: every path that is shorter than this was seen.
  double seen_to() const {
    return std::min({limit_, blocked_, stopped_ ? open_ : std::numeric_limits<double>::infinity()});
  }
  std::int64_t windows() const { return windows_; }
  const VertexReach& reached(std::int32_t v) const {
    static const VertexReach kUnreached;
    const VertexReach& reach = reach_[at(v)];
    return reach.query == query_ ? reach : kUnreached;
  }

  /// Where the found path goes: ends of straight pieces and crossings of edges, from the source on.
  SurfacePath path() const;
  /// The same to a vertex, after a run without a target that kept its windows; empty where there is none.
  SurfacePath path_to(std::int32_t vertex) const;

 private:
  /// One of the two edges through which a window leaves the face: seen from the corner that it shares with the edge
  /// entered, from which t runs towards the third corner.
  struct Exit {
    std::int32_t halfedge, near, far, opposite;  ///< side of the face; vertices: its ends, and the corner off it
    Real length, ux, uy;                         ///< of the edge; its direction
    Real base;                                   ///< length of the edge entered
  };
  struct Point2 {
    double x, y;
  };

  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  Side<Real> side(std::int32_t h) const {
    if constexpr (std::is_same_v<Real, double>) return mesh_->side(h);
    return make_side<Real>(mesh_->position(mesh_->tail(h)), mesh_->position(mesh_->head(h)),
                           mesh_->position(mesh_->tail(TriangleMesh::previous(h))));
  }
  VertexReach& touch(std::int32_t v);
  VertexGuide& guide(std::int32_t v) {
    VertexGuide& guide = guides_[at(v)];
    if (guide.query != query_) guide = VertexGuide{.query = query_};
    return guide;
  }
  double at_most(std::int32_t v) const {
    const VertexGuide& guide = guides_[at(v)];
    return guide.query == query_ ? guide.at_most : std::numeric_limits<double>::infinity();
  }
  /// Of every path from v to the target: asked once per query.
  double rest(std::int32_t v) {
    VertexGuide& known = guide(v);
    if (known.rest < 0) known.rest = bound_->from_vertex(v);
    return known.rest;
  }
  EdgeState& edge(std::int32_t h);
  double rest_through(std::int32_t h, const Window<Real>& w);

  void start(const EndPoint& source);
  void start_in_face(const EndPoint& source, std::int32_t face);
  void add(std::int32_t from_side, bool from_tail, Window<Real>& w);
  void enter(std::int32_t h, std::int32_t from_side, bool from_tail, Window<Real>& w);
  bool is_spent(const QueryLimits& limits, std::int64_t step);
  bool sabotaged(Window<Real>& w) const;
  bool is_sliver(const Window<Real>& w, const Real& length) const;
  bool stands_for(const Window<Real>& kept, const Window<Real>& w) const;
  bool merged(std::int32_t h, const Real& length, Window<Real>& w);
  bool join(std::int32_t h, const Real& length, Window<Real>& w);
  std::int32_t keep_part(const Window<Real>& w, std::int32_t next);
  std::int32_t parent_at(const Taken& w, double place) const;
  void turn_at_ends(std::int32_t h, Window<Real>& w) const;
  void block(double key);
  void propagate(std::int32_t waiting);
  std::int32_t needle_exit(std::int32_t h) const;
  bool leads_out(std::int32_t side) const;
  bool cross_needle(const Window<Real>& w, std::int32_t id);
  void leave(const Exit& exit, const Real& b0, const Real& b1, bool to_far, const Window<Real>& w, std::int32_t id);
  double around_ends(const Exit& exit, const Real& b0, const Real& b1, double wider0, double wider1,
                     const Window<Real>& w, const Window<Real>& next) const;
  double around_end(const Window<Real>& w, double after_begin, double before_end,
                    const exact::PlanePoint& corner) const;
  void see_corner(const Window<Real>& w, std::int32_t id, double distance);
  void see_target(const Window<Real>& w, std::int32_t id);
  /// What paths to v came to: bounds of the length, the length but for a few roundings, and what no path to the vertex
  /// before is shorter than. No path to v is shorter than that either, however near it is.
  struct Found {
    double at_least, at_most, about, before;
  };
  void reach(std::int32_t v, const Found& found, std::int32_t window, std::int32_t vertex, double direction,
             double slack);
  void reach_target(double at_least, double at_most, std::int32_t window, std::int32_t vertex);
  void fire(std::int32_t v);
  void fire_corner(std::int32_t v, const Corner& corner, double from, double to);
  void fire_edge(std::int32_t v, std::int32_t halfedge);
  void trace_back(std::int32_t window, Point2 towards, SurfacePath& reversed) const;
  std::int32_t root_of(std::int32_t window) const { return taken_[at(window)].root; }
  std::int32_t side_left(const Taken& w, std::int32_t parent) const;
  std::int32_t keep(const Window<Real>& w);
  std::int32_t face_between(std::int32_t v, std::int32_t other, const EndPoint& end) const;
  void trace_to_source(std::int32_t vertex, SurfacePath& reversed) const;

  const HalfEdges* mesh_;
  Forks forks_;
  LargeVector<VertexReach> reach_;
  LargeVector<VertexGuide> guides_;
  /// Where the state of a half-edge's edge is, and the query that this is of.
  struct Slot {
    std::uint32_t query = 0;
    std::int32_t index = -1;
  };
  LargeVector<Slot> slots_;
  LargeVector<EdgeState> edges_;  // of those that windows of this query came to
  SliverTable<Real> slivers_;
  LargeVector<Window<Real>> pool_;  // those that wait; a place is used again once its window is taken
  std::vector<std::int32_t> free_;  // such places
  LargeVector<Taken> taken_;        // where paths are asked for
  std::vector<Part> parts_;         // likewise
  WindowQueue queue_;
  std::uint32_t query_ = 0;

  const EndPoint *source_ = nullptr, *target_ = nullptr;
  const LowerBound* bound_ = nullptr;
  double best_ = 0, slack_ = 0, limit_ = 0;  // best length known; what ends the search
  double target_at_least_ = 0, target_at_most_ = 0, blocked_ = 0, crowded_ = 0, open_ = 0;
  std::int32_t target_window_ = -1, target_vertex_ = -1;
  bool stopped_ = false, out_of_memory_ = false, keeps_ = true, sabotaged_ = false;
  bool by_distance_ = false;  // from the source, else by keys
  Sabotage sabotage_;
  std::int64_t windows_ = 0;
};

}  // namespace leastcost
