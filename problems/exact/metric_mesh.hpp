// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/mesh/surface_path.hpp>

namespace leastcost {

/// The mesh whose Euclidean lengths are those of `mesh` in a constant metric: positions A (x - centre), rounded, the
/// numbers of vertices and faces as they were. A path goes over and back by the same map; points of faces keep their
/// coordinates.
class MetricMesh {
 public:
  MetricMesh(const TriangleMesh& mesh, const Eigen::Matrix3d& root) : MetricMesh(mesh, root, mesh.position(0)) {}
  MetricMesh(const TriangleMesh& mesh, const Eigen::Matrix3d& root, const Eigen::Vector3d& centre);

  const TriangleMesh& mesh() const { return mesh_; }
  SurfacePath there(SurfacePath path) const;
  SurfacePath back(SurfacePath path) const;

 private:
  Eigen::Matrix3d root_, inverse_;
  Eigen::Vector3d centre_;
  TriangleMesh mesh_;
};

}  // namespace leastcost
