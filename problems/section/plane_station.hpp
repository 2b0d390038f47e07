// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// A point of a smooth surface in R^3 on a plane that cuts it.
struct Station {
  Eigen::VectorXd u;                                ///< coordinates
  Eigen::Vector3d x = Eigen::Vector3d::Zero();      ///< position
  Points basis;                                     ///< tangent basis, coordinate x 2
  Points lift;                                      ///< 3 x 2: moves of the position by moves along `basis`
  Eigen::Vector3d along = Eigen::Vector3d::Zero();  ///< unit tangent of the curve in which the plane cuts

  /// Coordinates of the move `d`, a vector of the tangent plane.
  Eigen::VectorXd pulled_back(const Eigen::Vector3d& d) const;
  Eigen::Vector3d surface_normal() const;
};

/// Finds points that lie on a surface and on a plane: Newton steps onto the plane within the tangent plane, each
/// followed by the surface's own projection, so that it works for level sets, clouds and charts alike.
class StationFinder {
 public:
  /// The plane through `point` with the unit normal `normal`; the surface must outlive the finder.
  StationFinder(const ConstraintManifold& surface, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

  /// The station reached from coordinates near it; nothing where there is no projection, or where the plane touches the
  /// surface.
  std::optional<Station> reach(const Eigen::VectorXd& u);

 private:
  bool place(const Eigen::VectorXd& u, Station& out);
  bool correct(Station& s);

  const ConstraintManifold* surface_;
  const HasChart* chart_;
  Eigen::Vector3d point_, normal_;
  CoordinatePath one_;
  Points position_, jacobian_;
};

}  // namespace leastcost
