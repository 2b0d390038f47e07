// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <vector>

#include "benchmarks/comparison/method.hpp"
#include "problems/exact/half_edges.hpp"

namespace leastcost::comparison {

/// Of a distance: ties are kept.
inline constexpr double kWindowTie = 1e-12;

/// Straight continuations of the paths from one root over one row of faces: the part [begin, end] of the edge of
/// `halfedge`, whose face is entered next, and the image of the root at (x, -height) in the plane where that edge runs
/// from (0, 0) to (length, 0).
struct PlainWindow {
  std::int32_t halfedge = -1;
  std::int32_t parent = -1;  ///< or -1: the root lies on the face before
  std::int32_t root = -1;    ///< vertex
  std::int32_t child[2] = {-1, -1};
  bool dead = false;
  std::int32_t level = 0;  ///< faces that the paths have crossed since the root
  double sigma = 0;        ///< distance of the root from the source
  double begin = 0, end = 0, x = 0, height = 0;

  double distance_at(double along) const;  ///< of a point of the edge, from the source
  double key() const;                      ///< the least of these within the part
};

/// What the three window methods share: windows, distances of vertices and how they came about. Textbook: plain
/// doubles, every vertex that is no convex or flat one sends windows all around it.
class WindowTables {
 public:
  explicit WindowTables(const TriangleMesh& mesh) : edges_(mesh) {}

  void begin(std::int32_t source);
  const HalfEdges& edges() const { return edges_; }
  const PlainWindow& window(std::int32_t id) const { return pool_[at(id)]; }
  PlainWindow& window(std::int32_t id) { return pool_[at(id)]; }
  long size() const { return static_cast<long>(pool_.size()); }
  bool full() const;
  std::int32_t add(const PlainWindow& w);
  double distance(std::int32_t v) const { return reach_[at(v)].distance; }
  bool is_stale(const PlainWindow& w) const { return w.dead || w.sigma > distance(w.root); }

  /// The corner opposite to a window's edge: where the straight line to it crosses the edge, whether the window covers
  /// that place, and the distance.
  struct Corner {
    std::int32_t vertex;
    double crossing, distance;
    bool seen;
  };
  Corner corner(const PlainWindow& w) const;
  /// True when the vertex got nearer to the source by this.
  bool reach(std::int32_t v, double distance, std::int32_t window, std::int32_t from_vertex);
  /// Whether paths may bend around it.
  bool bends(std::int32_t v) const;
  /// Windows from a root over the edges opposite to it; its neighbours are reached. Calls made(window) and
  /// nearer(vertex) for those that got nearer.
  template <class Made, class Nearer>
  void fire(std::int32_t v, Made made, Nearer nearer);

  /// The window that goes on over the edge from the tail (side 0) or the head (side 1) to the third corner; false:
  /// nothing goes on there. With `filtered`, nothing that the vertices know a shorter way to (Xin and Wang 2009).
  bool go_on(std::int32_t id, int side, bool filtered, PlainWindow& out) const;

  SurfacePath path(std::int32_t target) const;

 private:
  struct Reach {
    double distance;
    std::int32_t window, vertex;  ///< it came through; neither: the source
  };
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  bool window_from(std::int32_t v, std::int32_t opposite, PlainWindow& out) const;
  Eigen::Vector2d place(std::int32_t h, std::int32_t v) const;

  HalfEdges edges_;
  std::vector<Reach> reach_;
  std::deque<PlainWindow> pool_;
  std::int32_t source_ = -1;
};

template <class Made, class Nearer>
void WindowTables::fire(std::int32_t v, Made made, Nearer nearer) {
  const TriangleMesh& mesh = edges_.mesh();
  for (const std::int32_t w : mesh.neighbours(v)) {
    const double d = distance(v) + (mesh.position(w) - mesh.position(v)).norm();
    if (reach(w, d, -1, v)) nearer(w);
  }
  for (const std::int32_t f : mesh.faces_of_vertex(v))
    for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
      PlainWindow w;
      if (mesh.tail(h) != v && mesh.head(h) != v && window_from(v, h, w)) made(w);
    }
}

}  // namespace leastcost::comparison
