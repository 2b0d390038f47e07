// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// The section of a mesh with a plane. A vertex in the plane counts as below it, so that every face is crossed through
/// two of its edges or not at all, wherever vertices, edges or whole faces lie in the plane.
class PlaneSection {
 public:
  PlaneSection(const TriangleMesh& mesh, const Eigen::Vector3d& through, const Eigen::Vector3d& normal)
      : mesh_(&mesh), through_(through), normal_(normal) {}

  double height(std::int32_t v) const { return (mesh_->position(v) - through_).dot(normal_); }
  bool crosses(std::int32_t h) const { return (height(mesh_->tail(h)) > 0) != (height(mesh_->head(h)) > 0); }
  Eigen::Vector3d crossing(std::int32_t h) const;
  /// The other edge of its face through which the plane leaves, entering by halfedge h.
  std::int32_t exit(std::int32_t h) const {
    const std::int32_t next = TriangleMesh::next(h);
    return crosses(next) ? next : TriangleMesh::previous(h);
  }

 private:
  const TriangleMesh* mesh_;
  Eigen::Vector3d through_, normal_;
};

/// The curves in which a plane cuts a mesh.
struct SectionCurves {
  std::vector<SurfacePath> closed;  ///< first and last point of each are the same
  int at_border = 0;                ///< curves that end where the mesh does
  int at_edge = 0;                  ///< curves that end at an edge with three or more faces
};

/// All of them, in the order of their first faces; what is a single point is left out. Linear in the number of faces.
SectionCurves section_curves(const TriangleMesh& mesh, const Eigen::Vector3d& through, const Eigen::Vector3d& normal,
                             const Deadline& deadline = {});

}  // namespace leastcost
