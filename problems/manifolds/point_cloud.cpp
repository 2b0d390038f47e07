// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/point_cloud.hpp>

#include <Eigen/Geometry>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>
#include "problems/manifolds/bordered_cloud.hpp"

namespace leastcost {

void PointCloudManifoldOptions::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "Point cloud: PLY, or text with rows x y z [nx ny nz].", .required = true});
  visit.field("neighbours", settings.neighbours,
              {.help = "Nearest neighbours of a point: its links in the graph, and what its local spacing is measured "
                       "from.",
               .minimum = PointCloudSettings::kFewestNeighbours,
               .maximum = PointCloudSettings::kMostNeighbours});
  visit.field_or_zero("radius", settings.radius,
                      {.help = "Support of the moving least squares fit; 0: 4, and wider where the cloud is noisy.",
                       .unit = "local spacings",
                       .minimum = 0,
                       .maximum = 100});
  visit.field(
      "max_edge", settings.max_edge,
      {.help = "Longest link of the neighbour graph, against jumps between sheets; a longer one joins parts with a "
               "gap between them.",
       .unit = "local spacings",
       .minimum = 1});
  visit.choice("normals", settings.normals,
               {.help = "Normals of the file, or estimated by robust quadratic fits and oriented along a minimum "
                        "spanning tree. auto: those of the file where they agree with the estimate."});
}

PointCloudManifold::PointCloudManifold(PointCloud cloud)
    : EmbeddedManifold({3, 3, 2}), cloud_(std::move(cloud)), surface_(cloud_), graph_(cloud_) {}

std::shared_ptr<const ConstraintManifold> PointCloudManifold::coarser() const {
  std::call_once(made_coarser_, [this] {
    coarser_ = surface_of(cloud_.thinned());
    has_coarser_ = true;
  });
  return coarser_;
}

bool PointCloudManifold::project_point(Eigen::Ref<Eigen::VectorXd> x) const {
  Eigen::Vector3d y = x;
  if (!surface_.project(y)) return false;
  x = y;
  return true;
}

void PointCloudManifold::tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const {
  // Points of a path have been projected; elsewhere (a rejected trial) any frame will do.
  const Eigen::Vector3d normal = surface_.normal(x).value_or(Eigen::Vector3d::UnitZ());
  basis.col(0) = normal.unitOrthogonal();
  basis.col(1) = normal.cross(Eigen::Vector3d(basis.col(0)));
}

std::shared_ptr<const PointCloudManifold> surface_of(PointCloud cloud) {
  if (cloud.has_border()) return std::make_shared<const BorderedCloud>(std::move(cloud));
  return std::make_shared<const PointCloudManifold>(std::move(cloud));
}

std::shared_ptr<const PointCloudManifold> make_point_cloud_manifold(const PointCloudManifoldOptions& options,
                                                                    const std::filesystem::path& folder) {
  PointCloud cloud(read_point_cloud(folder / options.file), options.settings);
  const double share = cloud.share_of_support();
  if (options.settings.radius && share > PointCloud::kMostOfCloud) {
    std::ostringstream why;
    why.precision(3);
    why << "a support of " << *options.settings.radius << " local spacings holds " << 100 * share
        << " % of the cloud; the most is " << 100 * PointCloud::kMostOfCloud << " %";
    throw OptionError("radius", why.str());
  }
  return surface_of(std::move(cloud));
}

}  // namespace leastcost
