// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace leastcost {

/// The least distance of a straight segment, or a triangle, in space from triangles, exact to rounding, by a hierarchy
/// of balls around them. Degenerate triangles count as the segments or points that they are. Immutable, shared by
/// threads.
class SegmentTree {
 public:
  using Triangle = std::array<Eigen::Vector3d, 3>;

  /// At least one triangle.
  explicit SegmentTree(std::vector<Triangle> triangles);

  /// Of a + t (b - a), t in [0, 1], length units. Where the segment meets triangles: 0, and the t of the first.
  double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double& t) const;
  /// Of a triangle, length units, and the point of it that is nearest; 0 where it meets others.
  double distance(const Triangle& triangle, Eigen::Vector3d& nearest) const;

 private:
  struct Node {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = 0;
    std::int32_t first = 0, count = 0;  // triangles; an inner node's children are the node after it and `second`
    std::int32_t second = -1;           // -1: a leaf
  };
  std::int32_t build(std::int32_t first, std::int32_t count);
  /// Offers the triangles of leaves while they may be nearer: `bound(node)`, `offer(triangle)`, `best()` are distances.
  template <class Bound, class Offer, class Best>
  void search(const Bound& bound, const Offer& offer, const Best& best) const;

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace leastcost
