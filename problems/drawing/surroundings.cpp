// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/drawing/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Surroundings Surroundings::enlarged(double part) const {
  const double by = part * extent().maxCoeff();
  return {lower.array() - by, upper.array() + by};
}

Surroundings around(const Points& x) {
  Surroundings box{Eigen::VectorXd::Constant(x.rows(), kInfinity), Eigen::VectorXd::Constant(x.rows(), -kInfinity)};
  for (const auto column : x.colwise()) {
    if (!column.allFinite()) continue;
    box.lower = box.lower.cwiseMin(column);
    box.upper = box.upper.cwiseMax(column);
  }
  return box;
}

Surroundings coordinate_bounds(const ConstraintManifold& manifold, const Eigen::VectorXd& inside) {
  const double far = 1e12 * std::max(1.0, inside.cwiseAbs().maxCoeff());
  Surroundings bounds{Eigen::VectorXd::Constant(inside.size(), -kInfinity),
                      Eigen::VectorXd::Constant(inside.size(), kInfinity)};
  CoordinatePath one{inside, {}, true};
  for (Index i = 0; i < inside.size(); ++i) {
    for (const double side : {-1.0, 1.0}) {
      one.u.col(0) = inside;
      one.u(i, 0) = side * far;
      const bool found = manifold.project(one).failed.empty() && std::abs(one.u(i, 0)) < far / 2;
      if (found) (side < 0 ? bounds.lower : bounds.upper)[i] = one.u(i, 0);
    }
  }
  return bounds;
}

}  // namespace leastcost
