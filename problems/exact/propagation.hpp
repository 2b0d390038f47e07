// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "problems/exact/end_point.hpp"
#include "problems/exact/half_edges.hpp"
#include "problems/exact/lower_bound.hpp"
#include "problems/exact/window.hpp"

namespace leastcost {

/// Windows from a source over the surface in the order of their keys: what the paths through them cost at least, with
/// what is left to the target. docs/numerics.md Sec. 5.4 says why every shortest path stays within some window,
/// whatever rounding does. Reusable: keeps its memory. One object per thread.
template <class Real>
class Propagation {
 public:
  explicit Propagation(const HalfEdges& mesh);

  /// Runs until nothing open can beat the best path by more than the slack. Without a target: until all is reached.
  void run(const EndPoint& source, const EndPoint* target, const LowerBound& bound, const QueryLimits& limits);

  /// No path to the target is shorter, whatever stopped the run; infinite where there is none.
  double lower_bound() const;
  /// There is a path to the target that is at most this long: the found one; infinite where none was found.
  double found() const { return target_at_most_; }
  /// Paths that could be shorter than the best run over an edge with three or more faces or a face without height.
  bool blocked() const { return blocked_ < limit_; }
  /// Of these, over an edge with three or more faces: more digits would not help.
  bool at_fork() const { return fork_ < limit_; }
  /// The budget of windows was spent, or somebody asked to stop.
  bool stopped() const { return stopped_; }
  std::int64_t windows() const { return windows_; }
  const VertexReach& reached(std::int32_t v) const {
    static const VertexReach kUnreached;
    const VertexReach& reach = reach_[at(v)];
    return reach.query == query_ ? reach : kUnreached;
  }

  /// Where the found path goes: ends of straight pieces and crossings of edges, from the source on.
  SurfacePath path() const;

 private:
  struct Entry {
    double key;
    std::int32_t id;                                                      ///< of a window, or ~vertex
    bool operator<(const Entry& other) const { return key > other.key; }  // least key first
  };
  /// The best window that sees the third corner over a half-edge: of two such windows the worse one need not go on on
  /// the far side of the better one's ray (Chen and Han 1990).
  struct Apex {
    std::uint32_t query = 0;
    double at_most = 0, crossing = 0, margin = 0;
  };
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
  Side<Real> side(std::int32_t h) const;
  VertexReach& touch(std::int32_t v);
  double at_most(std::int32_t v) const { return reached(v).at_most; }

  void start(const EndPoint& source);
  void start_in_face(const EndPoint& source, std::int32_t face);
  void add(std::int32_t from_side, bool from_tail, Window<Real> w);
  void turn_at_ends(std::int32_t h, Window<Real>& w) const;
  void block(double key);
  void propagate(std::int32_t id);
  bool dominated(const Window<Real>& w) const;
  void leave(const Exit& exit, Real b0, Real b1, bool to_far, const Window<Real>& w, std::int32_t id);
  void see_corner(const Window<Real>& w, std::int32_t id, double distance, double beside);
  void see_target(const Window<Real>& w, std::int32_t id);
  void reach(std::int32_t v, double at_least, double at_most, std::int32_t window, std::int32_t vertex,
             double direction, double slack);
  void reach_target(double at_least, double at_most, std::int32_t window, std::int32_t vertex);
  void fire(std::int32_t v);
  void fire_corner(std::int32_t v, const Corner& corner, double from, double to);
  void fire_edge(std::int32_t v, std::int32_t halfedge);
  void push(double key, std::int32_t id);
  void trace_back(std::int32_t window, Point2 towards, SurfacePath& reversed) const;

  const HalfEdges* mesh_;
  std::vector<VertexReach> reach_;
  std::vector<Apex> apex_;
  std::vector<Window<Real>> pool_;
  std::vector<std::int32_t> free_;
  std::vector<Entry> queue_;
  std::uint32_t query_ = 0;

  const EndPoint *source_ = nullptr, *target_ = nullptr;
  const LowerBound* bound_ = nullptr;
  double best_ = 0, slack_ = 0, limit_ = 0;  // best length known; what ends the search
  double target_at_least_ = 0, target_at_most_ = 0, blocked_ = 0, fork_ = 0, open_ = 0;
  std::int32_t target_window_ = -1, target_vertex_ = -1;
  bool stopped_ = false;
  std::int64_t windows_ = 0;
};

}  // namespace leastcost
