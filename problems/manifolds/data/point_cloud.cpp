// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/data/point_cloud.hpp>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/framework/domain/sees_bounds.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>

namespace leastcost {
namespace {

constexpr double kAlongBorder = 1e-9;  ///< of a step: what of it may lead off the border that it runs along

void lose(Eigen::Ref<Eigen::VectorXd> x) { x.setConstant(std::numeric_limits<double>::quiet_NaN()); }

/// The surface of a cloud with a border: the rim of a partial scan, holes. Paths come to rest on it and run along it,
/// around a hole, as along any bound.
class BorderedCloud final : public PointCloudManifold, public GoesBeyondBounds, public SeesBounds {
 public:
  using PointCloudManifold::PointCloudManifold;

  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  void retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const override;
  void bounds_within(const CoordinatePath& path, Index column, double reach,
                     std::vector<NearBound>& found) const override;
  void retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints& bounds,
                    CoordinatePath& to) const override;

 protected:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override;

 private:
  void move(const CoordinatePath& from, const Points& step, const BoundsOfPoints* onto, CoordinatePath& to) const;
};

bool BorderedCloud::project_point(Eigen::Ref<Eigen::VectorXd> x) const {
  Eigen::Vector3d y = x;
  if (!surface().project_within(y)) return false;
  x = y;
  return true;
}

/// A point on the border whose step leads along it, or outwards, stays on it.
void BorderedCloud::move(const CoordinatePath& from, const Points& step, const BoundsOfPoints* onto,
                         CoordinatePath& to) const {
  prepare_like(from, to);
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    const Eigen::Vector3d start = from.u.col(first + i), way = step.col(i);
    bool stays = onto != nullptr && !(*onto)[static_cast<std::size_t>(i)].empty();
    if (!stays) {
      const auto border = surface().border_near(start);
      stays = border && border->rests && border->outward.dot(way) >= -kAlongBorder * way.norm();
    }
    Eigen::Vector3d x = start + way;
    if (stays ? surface().project_onto_border(x) : surface().project_within(x))
      to.u.col(first + i) = x;
    else
      lose(to.u.col(first + i));
  }
}

void BorderedCloud::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  move(from, step, nullptr, to);
}

void BorderedCloud::retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints& bounds,
                                 CoordinatePath& to) const {
  move(from, step, &bounds, to);
}

void BorderedCloud::retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    const Eigen::Vector3d start = from.u.col(first + i), way = step.col(i);
    const auto border = surface().border_near(start);
    const bool stays = border && border->rests && std::abs(border->outward.dot(way)) <= kAlongBorder * way.norm();
    Eigen::Vector3d x = start + way;
    if (stays ? surface().project_onto_border(x) : surface().project_beyond(x))
      to.u.col(first + i) = x;
    else
      lose(to.u.col(first + i));
  }
}

int BorderedCloud::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  const auto border = surface().border_near(path.u.col(column));
  if (!border || !border->rests) return 0;
  normals.col(0) = border->outward;
  return 1;
}

void BorderedCloud::bounds_within(const CoordinatePath& path, Index column, double reach,
                                  std::vector<NearBound>& found) const {
  found.clear();
  const auto border = surface().border_near(path.u.col(column));
  if (border && border->gap <= reach) found.push_back({0, -border->outward, border->rests ? 0 : border->gap});
}

}  // namespace

void PointCloudManifoldOptions::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "Point cloud: PLY, or text with rows x y z [nx ny nz].", .required = true});
  visit.field(
      "neighbours", settings.neighbours,
      {.help = "Number of nearest neighbours of a point: they are its links in the graph and give its local spacing.",
       .minimum = PointCloudSettings::kFewestNeighbours,
       .maximum = PointCloudSettings::kMostNeighbours});
  visit.field_or_zero("radius", settings.radius,
                      {.help = "Radius of the moving least squares fit; 0: 4, larger where the cloud is noisy.",
                       .unit = "local spacings",
                       .minimum = 0,
                       .maximum = 100});
  visit.field("max_edge", settings.max_edge,
              {.help = "Longest link of the neighbour graph, to prevent jumps between sheets; a larger value joins "
                       "parts with a gap between them.",
               .unit = "local spacings",
               .minimum = 1});
  visit.choice("normals", settings.normals,
               {.help = "given: the normals of the file. estimate: by robust quadratic fits, oriented along a minimum "
                        "spanning tree. auto: those of the file where they agree with the estimate."});
}

PointCloudManifold::PointCloudManifold(PointCloud cloud, const Deadline& deadline)
    : EmbeddedManifold({3, 3, 2}), cloud_(std::move(cloud)), surface_(cloud_), graph_(cloud_, deadline) {}

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

std::shared_ptr<const PointCloudManifold> surface_of(PointCloud cloud, const Deadline& deadline) {
  if (cloud.has_border()) return std::make_shared<const BorderedCloud>(std::move(cloud), deadline);
  return std::make_shared<const PointCloudManifold>(std::move(cloud), deadline);
}

std::shared_ptr<const PointCloudManifold> make_point_cloud_manifold(const PointCloudManifoldOptions& options,
                                                                    const std::filesystem::path& folder) {
  PointCloud cloud(read_point_cloud(folder / options.file), options.settings);
  const double share = cloud.share_of_support();
  if (options.settings.radius && share > PointCloud::kMostOfCloud) {
    std::ostringstream why;
    why.precision(3);
    why << "a radius of " << *options.settings.radius << " local spacings contains " << 100 * share
        << " % of the cloud; the limit is " << 100 * PointCloud::kMostOfCloud << " %";
    throw OptionError("radius", why.str());
  }
  return surface_of(std::move(cloud));
}

}  // namespace leastcost
