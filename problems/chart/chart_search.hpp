// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// Coordinates of points of a chart that are locally nearest to a position in space, nearest first: Gauss-Newton steps
/// from a grid over its periods and bounds (where a coordinate has neither: from a range about 0 of the size of the
/// position). At least one; there may be nearer points that the grid does not see.
std::vector<Eigen::VectorXd> nearest_in_chart(const ConstraintManifold& chart, const Eigen::Vector3d& position);

}  // namespace leastcost
