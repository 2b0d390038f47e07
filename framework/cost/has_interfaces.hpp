// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/framework/path/path.hpp>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

class ConstraintManifold;

/// Where a curve meets an interface, at which the cost of a unit of length jumps.
struct Crossing {
  Eigen::VectorXd place;                     ///< ambient
  int interface = 0;                         ///< its number
  int from = 0, to = 0;                      ///< the layers before and after
  double index_before = 0, index_after = 0;  ///< cost of a unit of length there
  double angle_before = 0, angle_after = 0;  ///< to the normal of the interface, radians: pi / 2 along it
  double slowness = 0;                       ///< index times the sine of the angle, before it
  /// Difference of the two slownesses along the interface, as vectors, relative to the larger index. Snell's law: 0.
  double mismatch = 0;
  double rounding = 0;  ///< what rounding of the coordinates may have added to it
};

/// Ability of a cost: it jumps at interfaces. Its moves have kinks there, which no chain of points resolves, so that
/// none is certified; a curve of least cost obeys Snell's law, which is part of its stationarity.
class HasInterfaces {
 public:
  virtual ~HasInterfaces() = default;
  /// The places where a polyline meets interfaces, measured on the polyline alone (ambient, d x m). A bend elsewhere,
  /// and a leg that is nowhere or passes an interface unseen, are crossings with the mismatch 2, which no angles have.
  /// Beyond the box of the domain, where it has one, no path leads.
  virtual std::vector<Crossing> crossings(const Points& polyline, const ConstraintManifold& domain) const = 0;
};

}  // namespace leastcost
