// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// An axis-parallel box around a path.
struct Surroundings {
  Eigen::VectorXd lower, upper;
  Eigen::VectorXd extent() const { return upper - lower; }
  Eigen::VectorXd centre() const { return (lower + upper) / 2; }
  /// With `part` of the longest side put on every side.
  Surroundings enlarged(double part) const;
};
/// The smallest one around all columns; columns that are not finite are left out.
Surroundings around(const Points& x);

/// Where the coordinates of a domain with bounds end, found by asking for the nearest points of far ones; infinite
/// where they do not end.
Surroundings coordinate_bounds(const ConstraintManifold& manifold, const Eigen::VectorXd& inside);

}  // namespace leastcost
