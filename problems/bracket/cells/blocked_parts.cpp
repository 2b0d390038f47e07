// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/blocked_parts.hpp"

namespace leastcost::bracket {

BlockedParts::BlockedParts(const std::function<double(const Eigen::Vector2d&)>& depth, const Grid<2>& grid,
                           const Place<2>& cell) {
  const auto add = [&](const CellPart<2>& part, const auto& self) -> void {
    const double parts = 1 << part.level, x = (part.at[0] + 0.5) / parts - 0.5, y = (part.at[1] + 0.5) / parts - 0.5;
    if (depth(grid.node(cell) + grid.h * Eigen::Vector2d(x, y)) > grid.half_diagonal() / parts) {
      bits_ |= mask(part);
    } else if (part.level < kLevels) {
      for (const int upper : {0, 1})
        for (const int right : {0, 1}) self(part.half({right, upper}), self);
    }
  };
  add({}, add);
}

std::uint64_t BlockedParts::mask(const CellPart<2>& part) {
  const int side = 1 << (kLevels - part.level);
  const std::uint64_t row = ((std::uint64_t{1} << side) - 1) << (part.at[0] * side);
  std::uint64_t out = 0;
  for (int k = 0; k < side; ++k) out |= row << ((part.at[1] * side + k) << kLevels);
  return out;
}

}  // namespace leastcost::bracket
