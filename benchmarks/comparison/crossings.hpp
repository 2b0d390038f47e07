// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "benchmarks/comparison/method.hpp"

namespace leastcost::comparison {

/// Where a path crosses an edge: from the face of `halfedge` into the one across, at part t of the way from its tail.
struct Crossing {
  std::int32_t halfedge;
  double t;
};

/// A path between two vertices as the edges it crosses, what LS, LLM and DE work on.
class CrossingPath {
 public:
  /// Along the shortest edge path, past each of its vertices on the side of the smaller angle: the crossings there are
  /// `off` (part of the edge) from the vertex. Throws InputError where a border leaves no side, or no path leads.
  CrossingPath(const TriangleMesh& mesh, std::int32_t source, std::int32_t target, double off, const Stop& stop);

  std::vector<Crossing>& crossings() { return crossings_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  Eigen::Vector3d point(std::size_t i) const;  ///< 0: the source, then the crossings, then the target
  double length() const;
  SurfacePath path() const;

  /// Crossings [first, last) that lie in one vertex, `vertex`.
  struct Knot {
    std::size_t first, last;
    std::int32_t vertex;
  };
  std::vector<Knot> knots(double tolerance) const;
  /// Straightens the path past a knot, in the unfolding of the faces around its vertex, on this side or on the other
  /// one if its angle is below pi. False: it is straight already, or a border is in the way.
  bool untie(const Knot& knot);
  /// The same for all of them; true where something changed.
  bool untie_all(double tolerance);
  /// Drops what crosses an edge there and back at once.
  void drop_returns();

 private:
  Eigen::Vector3d at(const Crossing& c) const;
  std::int32_t face_before(std::size_t i) const { return crossings_[i].halfedge / 3; }
  std::int32_t face_behind(std::size_t i) const { return mesh_->across(crossings_[i].halfedge) / 3; }

  const TriangleMesh* mesh_;
  std::int32_t source_, target_;
  std::vector<Crossing> crossings_;
};

}  // namespace leastcost::comparison
