// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/options.hpp>
#include <leastcost/problems/cloud/has_point_cloud.hpp>

namespace leastcost {

struct PointCloudManifoldOptions {
  std::string file = {};
  PointCloudSettings settings = {};
  void fields(FieldVisitor& visit);
};

/// The smooth surface that moving least squares lay through a point cloud (VFCS 4.4.4;
/// problems/geometry/cloud_surface). Projection is along the gradient of the implicit form, tangent planes are those of
/// the surface itself. Where the samples end (the border of a partial scan, holes wider than a support) there is no
/// surface, and a path cannot rest against that border.
class PointCloudManifold final : public EmbeddedManifold, public HasPointCloud, public HasCoarserVersion {
 public:
  explicit PointCloudManifold(PointCloud cloud);
  PointCloudManifold(const PointCloudManifold&) = delete;  // the surface refers to the cloud beside it
  PointCloudManifold& operator=(const PointCloudManifold&) = delete;

  const PointCloud& cloud() const override { return cloud_; }
  const CloudSurface& surface() const override { return surface_; }
  const CloudGraph& graph() const override { return graph_; }
  std::shared_ptr<const ConstraintManifold> coarser() const override;

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override;
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override;

 private:
  PointCloud cloud_;
  CloudSurface surface_;
  CloudGraph graph_;
};

/// Reads the file (relative to `folder`) and builds the surface. Throws InputError, OptionError.
std::shared_ptr<const PointCloudManifold> make_point_cloud_manifold(const PointCloudManifoldOptions& options,
                                                                    const std::filesystem::path& folder);

}  // namespace leastcost
