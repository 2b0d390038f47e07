// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// The point of a mesh that is closest to a place.
struct ClosestPoint {
  SurfacePoint where;                                  ///< face and weights of its corners
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< place of the point
  double distance = 0;                                 ///< length units
};

/// Nearest point of a triangle mesh, exactly (to rounding), by a hierarchy of bounding boxes in double precision.
/// Self-contained: it copies what it needs of the mesh. Queries are const, allocate nothing and may run from several
/// threads.
class ClosestPointTree {
 public:
  /// Takes some 1.3 us per face; throws Interrupted once the deadline has passed.
  explicit ClosestPointTree(const TriangleMesh& mesh, const Deadline& deadline = {});

  /// Nearest point to p. `hint`, a face thought to be near (or anything that is no face, such as -1), bounds the search
  /// from the start: most queries of a point that moved little then visit a handful of triangles. The answer's position
  /// does not depend on the hint unless two places are equally near; the face may, where p is nearest to an edge or
  /// vertex: ties go to the hint's face or the lowest face number. When p is not finite or beyond 1e150 the answer's
  /// face is -1, its position and distance are NaN.
  ClosestPoint nearest(const Eigen::Vector3d& p, std::int32_t hint = -1) const;

 private:
  /// Children are neighbours in memory and start at even indices: the sibling of node n is n ^ 1. Index 1 is unused.
  struct alignas(64) Node {
    Eigen::Vector3d lower, upper;
    std::int32_t first = 0;  // leaf: first triangle; inner node: first child
    std::int32_t count = 0;  // leaf: number of triangles; inner node: 0
    std::int32_t parent = -1;
  };
  /// A face as the query needs it. Corners are rotated so that corner 0 faces the longest side, which makes the
  /// gradients of the barycentric coordinates of corners 1 and 2 as accurate as they can be.
  struct alignas(64) Triangle {
    Eigen::Vector3d corner[3];
    Eigen::Vector3d gradient[2];
    std::int32_t face = -1;
    std::int8_t rotation = 0;   // corner 0 is corner `rotation` of the face
    std::int8_t backwards = 0;  // bit k: the side opposite to corner k runs from the higher to the lower vertex number
    std::int8_t thin = 0;       // the gradients are too inaccurate to tell inside from outside
  };
  struct Best;
  struct Builder;

  static Triangle make_triangle(const TriangleMesh& mesh, std::int32_t f);
  void visit_triangle(const Eigen::Vector3d& p, std::int32_t slot, Best& best) const;
  void visit_subtree(const Eigen::Vector3d& p, std::int32_t root, Best& best) const;

  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;  // leaf after leaf
  std::vector<std::int32_t> leaf_of_face_;
};

}  // namespace leastcost
