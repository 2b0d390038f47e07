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

/// For every position the index of the one that it joins: the lowest that joins itself and lies within the distance, so
/// that no position moves by more, however many lie in a row. Positions must be finite, the distance positive. O(n)
/// where few lie within it of each other.
std::vector<std::int32_t> lowest_within(std::span<const Eigen::Vector3d> positions, double distance);

}  // namespace leastcost
