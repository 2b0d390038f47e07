// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {

/// A mesh whose vertices that edges join within rounding are put at one place. Where two vertices are that near, the
/// image of one is as near to the other as its rounding, and windows go round it without end, or pass it at the wrong
/// side. Vertices at exactly one place have no such side. The numbers of vertices and faces, and the barycentric
/// coordinates of points, are those of the given mesh.
class GatheredMesh {
 public:
  /// None where no edge is that short, as on most meshes.
  static std::optional<GatheredMesh> of(const TriangleMesh& mesh);

  const TriangleMesh& mesh() const { return mesh_; }
  /// Between any two points the distances on this mesh and on the given one differ by no more, length units.
  /// A shortest path crosses a face at most once, by a straight piece along which the weight of a vertex changes by one
  /// at most. So moving the vertex by d changes the length there by d at most: d times its faces in all.
  double error() const { return error_; }
  /// A path as one of the given mesh, between the places of its ends there: off the faces by no more than the vertices
  /// were moved. `face`: of the source, for ends that are at one place here.
  SurfacePath back(SurfacePath path, const Eigen::Vector3d& source, const Eigen::Vector3d& target,
                   std::int32_t face) const;

 private:
  GatheredMesh(TriangleMesh mesh, double error);

  TriangleMesh mesh_;
  double error_;
};

}  // namespace leastcost
