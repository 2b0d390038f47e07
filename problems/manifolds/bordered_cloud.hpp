// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/framework/domain/sees_bounds.hpp>
#include <leastcost/problems/manifolds/point_cloud.hpp>

namespace leastcost {

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

}  // namespace leastcost
