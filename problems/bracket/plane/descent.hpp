// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "problems/bracket/plane/distance_bound.hpp"

namespace leastcost::bracket {

/// Ways down a distance field from `from` to the end that it is of, as polylines in the box, from the end on: straight
/// down, and from a little to both sides, for on a ridge between two ways straight down is neither.
std::vector<Eigen::Matrix2Xd> ways_down(const Level& level, const DistanceField& field, const Eigen::Vector2d& from);

}  // namespace leastcost::bracket
