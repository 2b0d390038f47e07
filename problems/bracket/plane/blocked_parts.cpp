// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/plane/blocked_parts.hpp"

namespace leastcost::bracket {

BlockedParts::BlockedParts(const std::function<double(const Eigen::Vector2d&)>& depth, const CellGrid& grid, int i,
                           int j) {
  const auto add = [&](const CellPart& part, const auto& self) -> void {
    const double parts = 1 << part.level, x = (part.column + 0.5) / parts - 0.5, y = (part.row + 0.5) / parts - 0.5;
    if (depth(grid.node(i, j) + grid.h * Eigen::Vector2d(x, y)) > grid.half_diagonal() / parts) {
      bits_ |= mask(part);
    } else if (part.level < kLevels) {
      for (const bool upper : {false, true})
        for (const bool right : {false, true}) self(part.half(right, upper), self);
    }
  };
  add({}, add);
}

std::uint64_t BlockedParts::mask(const CellPart& part) {
  const int side = 1 << (kLevels - part.level);
  const std::uint64_t row = ((std::uint64_t{1} << side) - 1) << (part.column * side);
  std::uint64_t out = 0;
  for (int k = 0; k < side; ++k) out |= row << ((part.row * side + k) << kLevels);
  return out;
}

}  // namespace leastcost::bracket
