// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/problems/cloud/has_point_cloud.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/manifolds/file_places.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include <leastcost/problems/section/is_surface.hpp>

namespace leastcost {

struct PointCloudManifoldOptions {
  std::string file = {};
  PointCloudSettings settings = {};
  void fields(FieldVisitor& visit);
};

/// The smooth surface that moving least squares lay through a point cloud (VFCS 4.4.4;
/// problems/cloud/cloud_surface). Projection is along the gradient of the implicit form, tangent planes are those of
/// the surface itself. Where the samples end (the border of a partial scan, holes wider than a support) there is no
/// surface; the domain that surface_of() makes lets paths rest there.
class PointCloudManifold : public EmbeddedManifold,
                           public HasPointCloud,
                           public HasCoarserVersion,
                           public HasUnresolvedPlaces,
                           public ExplainsProjection,
                           public HasGraph,
                           public HasVertices,
                           public IsSurface,
                           public MadeFromData,
                           public DrawsItself {
 public:
  /// Throws Interrupted.
  explicit PointCloudManifold(PointCloud cloud, const Deadline& deadline = {});
  PointCloudManifold(const PointCloudManifold&) = delete;  // the surface refers to the cloud beside it
  PointCloudManifold& operator=(const PointCloudManifold&) = delete;

  const PointCloud& cloud() const override { return cloud_; }
  const CloudSurface& surface() const override { return surface_; }
  const CloudGraph& graph() const override { return graph_; }
  std::shared_ptr<const ConstraintManifold> coarser() const override;
  bool has_made_coarser() const override { return has_coarser_; }
  std::string why_unresolved(const CoordinatePath& path) const override;
  std::string why_not_projected(const Eigen::VectorXd& x) const override;
  FirstPath least_cost_edges(const Problem& problem, const Monitor& monitor) const override;
  /// The sample with this number.
  PathEnd vertex(int number) const override;
  double diameter() const override { return cloud_.diameter(); }
  std::vector<std::string> notes() const override;
  std::vector<DataCount> counts() const override;
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override;
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override;

 private:
  PointCloud cloud_;
  CloudSurface surface_;
  CloudGraph graph_;
  mutable std::once_flag made_coarser_;
  mutable std::shared_ptr<const ConstraintManifold> coarser_;
  mutable std::atomic<bool> has_coarser_ = false;
};

/// The surface of a cloud. Where it has a border, the rim of a partial scan or holes, paths come to rest on it and run
/// along it, as along any bound. Throws Interrupted.
std::shared_ptr<const PointCloudManifold> surface_of(PointCloud cloud, const Deadline& deadline = {});

/// Reads the file (relative to `folder`) and builds the surface. Throws InputError, OptionError.
std::shared_ptr<const PointCloudManifold> make_point_cloud_manifold(const PointCloudManifoldOptions& options,
                                                                    const std::filesystem::path& folder);

}  // namespace leastcost
