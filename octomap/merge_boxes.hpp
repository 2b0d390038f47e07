// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace leastcost {

/// Cells of a grid in space: lower <= cell < upper.
struct CellBlock {
  std::array<std::int64_t, 3> lower = {}, upper = {};
};

/// Fewer blocks with the same union, of blocks without overlaps: those that share a whole face become one, along one
/// axis after the other, until none do.
std::vector<CellBlock> merged(std::vector<CellBlock> blocks);

}  // namespace leastcost
