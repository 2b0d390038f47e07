// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/exact/exact_search.hpp>

namespace leastcost::app {

/// The length of the shortest path between the nearest of some places and each vertex of a mesh.
struct MeshField {
  std::vector<double> values;  ///< per vertex of the mesh, length units; NaN: no path
  /// How much too large a value can be. Rounding alone, unless the search was `cut`.
  std::vector<double> errors;
  std::vector<SurfacePoint> places;  ///< where they are from
  bool cut = false;  ///< memory ran out, or paths run over faces without height: some values are upper bounds
};

/// Makes such fields of one mesh.
class MeshFields {
 public:
  using Stop = std::function<bool()>;

  /// The problem gives the mesh and the cost, which must be the length. Throws InputError, Interrupted.
  MeshFields(const Problem& problem, const Stop& stop);

  const TriangleMesh& mesh() const { return mesh_; }
  /// A place of the mesh as a point of its face.
  SurfacePoint point(const PathEnd& place) const;
  /// Exact, by windows. Throws Interrupted.
  MeshField from(std::vector<SurfacePoint> places, const Stop& stop) const;
  /// The shortest path from the nearest of the places to a point. Throws InputError where there is none; Interrupted.
  SurfacePath way(std::span<const SurfacePoint> places, const SurfacePoint& to, const Stop& stop) const;

 private:
  std::shared_ptr<const ConstraintManifold> domain_;  ///< which has the mesh
  const TriangleMesh& mesh_;
  ExactSearch search_;
};

/// By how much the shortest path through each vertex, from the places of one field to those of the other, exceeds
/// `least`, the length of the shortest of all: it may lead through no vertex.
MeshField corridor(const MeshField& from, const MeshField& to, double least);

/// Per vertex of the file; NaN too for a vertex of no face.
std::vector<double> in_order_of_file(const TriangleMesh& mesh, const MeshField& field);

}  // namespace leastcost::app
