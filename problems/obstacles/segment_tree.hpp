// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/median_tree.hpp>

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
  struct Ball {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = 0;
  };
  static Ball ball_around(std::span<const Triangle> triangles);

  MedianTree<Triangle, Ball> tree_;
};

}  // namespace leastcost
