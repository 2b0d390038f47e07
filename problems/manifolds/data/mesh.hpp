// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/domain/makes_on_demand.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/manifolds/file_places.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/post_processors/choose_global_proof.hpp>
#include <leastcost/problems/section/is_surface.hpp>

namespace leastcost {

struct MeshManifoldOptions {
  std::string file = {};
  bool weld = false;  ///< whether vertices at equal places become one
  int subdivide = 0;
  double weld_within = 0;  ///< length units; 0: what `weld` says
  void fields(FieldVisitor& visit);
};

/// Points on a triangle mesh in R^3 (VFCS 4.4.2): projection to the closest point, tangent planes from smooth
/// normals (face normals have a kink at every edge, on which every line search stalls), sites are faces.
class MeshManifold final : public ConstraintManifold,
                           public HasBounds,
                           public HasPieces,
                           public HasMesh,
                           public KnowsGlobalProofs,
                           public MakesOnDemand,
                           public HasGraph,
                           public HasVertices,
                           public HasFaces,
                           public HasFilePlaces,
                           public IsSurface,
                           public MadeFromData,
                           public DrawsItself {
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
  /// Made when it is first asked for: what only walks on the mesh never does. Threads may ask at once.
  const ClosestPointTree& tree() const override;
  void make(const Deadline& deadline) const override;
  bool is_asked_by(const CoordinatePath& path) const override;
  FirstPath least_cost_edges(const Problem& problem, const Monitor& monitor) const override;
  PathEnd vertex(int number) const override;
  PathEnd on_face(int face, const Eigen::Vector3d& barycentric) const override;
  /// face, fan, the corners v0 v1 v2 of the triangle and the barycentric coordinates b0 b1 b2.
  std::vector<std::string> place_columns() const override;
  Eigen::VectorXd place_in_file(Site site, const Eigen::VectorXd& x) const override;
  double diameter() const override { return mesh_.diameter(); }
  std::vector<std::string> notes() const override { return mesh_.notes(); }
  std::vector<DataCount> counts() const override;
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 private:
  std::optional<double> off_own_face(const Eigen::Vector3d& p, Site site) const;

  TriangleMesh mesh_;
  mutable std::once_flag tree_asked_;
  mutable std::optional<ClosestPointTree> tree_;
};

/// Reads the file (relative to `folder`) and builds the mesh. Throws InputError.
std::shared_ptr<const MeshManifold> make_mesh_manifold(const MeshManifoldOptions& options,
                                                       const std::filesystem::path& folder);

}  // namespace leastcost
