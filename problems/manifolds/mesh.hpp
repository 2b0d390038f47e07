// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/options.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>

namespace leastcost {

struct MeshManifoldOptions {
  std::string file = {};
  bool weld = false;
  int subdivide = 0;
  void fields(FieldVisitor& visit);
};

/// Points on a triangle mesh in R^3 (VFCS 4.4.2): projection to the closest point, tangent planes from smooth
/// normals (face normals have a kink at every edge, on which every line search stalls), sites are faces.
class MeshManifold final : public ConstraintManifold, public HasBounds, public HasPieces, public HasMesh {
 public:
  explicit MeshManifold(TriangleMesh mesh);

  Dimensions dimensions() const override { return {3, 3, 2}; }
  Shape shape() const override { return Shape::polyhedral; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  double residual(const CoordinatePath& path) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  void into_pieces(const CoordinatePath& path, Points& vectors) const override;
  const TriangleMesh& mesh() const override { return mesh_; }
  const ClosestPointTree& tree() const override { return tree_; }

 private:
  TriangleMesh mesh_;
  ClosestPointTree tree_;
};

/// Reads the file (relative to `folder`) and builds the mesh. Throws InputError.
std::shared_ptr<const MeshManifold> make_mesh_manifold(const MeshManifoldOptions& options,
                                                       const std::filesystem::path& folder);

}  // namespace leastcost
