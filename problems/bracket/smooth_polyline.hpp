// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace leastcost {

/// A fine polyline through the points of a chain (d x m) that stays in a box: on each segment the cubic through its
/// four nearest points, as the certificate takes it (framework/energy/curve_value.hpp).
Eigen::MatrixXd smooth_polyline(const Eigen::Ref<const Eigen::MatrixXd>& points, const Eigen::AlignedBoxXd& box);

}  // namespace leastcost
