// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/exact/double_double.hpp"
#include "problems/exact/large_pages.hpp"

namespace leastcost {

/// A face seen from one of its half-edges: the tail at the origin, the head at (length, 0), the third corner at (x, y)
/// with y >= 0. Length units; unfolded from coordinates, never from lengths. Errors: kSideError roundings times the
/// distance of the third corner. y is 0 where rounding leaves no height: nothing can be unfolded across such a face.
template <class Real>
struct Side {
  Real length = 0, x = 0, y = 0;
  Real back = 0;  ///< length - x, formed from the head: no cancellation beside it
};

/// Roundings in the angles and lengths of a Side, a bound.
inline constexpr double kSideError = 8;

/// What a shortest path may do at a vertex.
enum class VertexKind : std::uint8_t {
  convex,  ///< surely less than a full turn of surface: no shortest path goes through it
  flat,    ///< a full turn within rounding: what goes through it goes straight on, within `turn_error`
  saddle,  ///< more than a full turn, possibly: paths may bend around it
  border,  ///< on the border of one fan of faces
  joint,   ///< several fans, an edge with three or more faces, or a face without height: paths may go on anywhere
};

/// The corners around a vertex, laid out by angle.
struct Corner {
  std::int32_t halfedge = -1;  ///< whose tail is the vertex
  double begin = 0, end = 0;   ///< radians from the first corner of its fan
  bool forward = true;         ///< at `begin` lies the half-edge itself, at `end` the previous one of the face
};

/// The flat tables of one mesh that exact queries read. Immutable.
class HalfEdges {
 public:
  /// Throws Interrupted.
  explicit HalfEdges(const TriangleMesh& mesh, const Deadline& deadline = {});

  const TriangleMesh& mesh() const { return *mesh_; }
  std::int32_t tail(std::int32_t h) const { return tail_[at(h)]; }
  std::int32_t head(std::int32_t h) const { return tail_[at(TriangleMesh::next(h))]; }
  std::int32_t across(std::int32_t h) const { return across_[at(h)]; }
  const Eigen::Vector3d& position(std::int32_t v) const { return mesh_->position(v); }
  const Side<double>& side(std::int32_t h) const { return sides_[at(h)]; }
  /// Two corners of the face are at one place.
  bool is_needle(std::int32_t face) const {
    return position(tail(3 * face)) == position(tail(3 * face + 1)) ||
           position(tail(3 * face + 1)) == position(tail(3 * face + 2)) ||
           position(tail(3 * face + 2)) == position(tail(3 * face));
  }
  VertexKind kind(std::int32_t v) const { return kind_[at(v)]; }
  /// Sum of the corner angles of the fan (not of a joint).
  double angle(std::int32_t v) const { return angle_[at(v)]; }
  /// Bound on the error of any sum of corner angles at v, radians.
  double turn_error(std::int32_t v) const { return turn_error_[at(v)]; }
  std::span<const Corner> corners(std::int32_t v) const {
    const std::size_t first = at(begin_[at(v)]);
    return {corners_.data() + first, at(begin_[at(v) + 1]) - first};
  }
  /// The corner at the tail of h.
  const Corner& corner(std::int32_t h) const { return corners_[at(corner_of_[at(h)])]; }
  /// Largest absolute coordinate, length units: what rounding of a point's position is relative to.
  double reach() const { return reach_; }
  /// Length units.
  double mean_edge() const { return mean_edge_; }
  double longest_edge() const { return longest_edge_; }

 private:
  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  void lay_out(std::int32_t v, std::vector<std::int32_t>& open);

  const TriangleMesh* mesh_;
  LargeVector<std::int32_t> tail_, across_;
  LargeVector<Side<double>> sides_;
  std::vector<std::int32_t> begin_;      // per vertex, into corners_
  LargeVector<Corner> corners_;          // vertex by vertex, in the order of a walk around it
  LargeVector<std::int32_t> corner_of_;  // per half-edge, into corners_
  std::vector<VertexKind> kind_;
  std::vector<double> angle_, turn_error_;
  double reach_ = 0, mean_edge_ = 0, longest_edge_ = 0;
};

/// The side of half-edge h, computed in Real.
template <class Real>
Side<Real> make_side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace leastcost
