// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace leastcost {

/// For every position the lowest index that has an equal one (-0 equals 0). Positions must be finite. O(n log n).
std::vector<std::int32_t> lowest_equal(std::span<const Eigen::Vector3d> positions);

}  // namespace leastcost
