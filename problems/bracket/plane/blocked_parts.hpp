// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "problems/bracket/cell_grid.hpp"

namespace leastcost::bracket {

/// One of the 4^level equal squares of a cell, in columns and rows of them.
struct CellPart {
  int level = 0, column = 0, row = 0;
  CellPart half(bool right, bool upper) const {
    return {level + 1, 2 * column + (right ? 1 : 0), 2 * row + (upper ? 1 : 0)};
  }
};

/// Which of 8 x 8 equal squares of a cell lie wholly within obstacles: no path is there, and nothing need be proved.
class BlockedParts {
 public:
  static constexpr int kLevels = 3;
  BlockedParts() = default;
  /// `depth` of a place: at most its distance from all places outside the obstacles, positive inside.
  BlockedParts(const std::function<double(const Eigen::Vector2d&)>& depth, const CellGrid& grid, int i, int j);

  bool any() const { return bits_ != 0; }
  /// Of the cell: whether no path is in this part.
  bool holds(const CellPart& part) const { return (~bits_ & mask(part)) == 0; }

 private:
  static std::uint64_t mask(const CellPart& part);

  std::uint64_t bits_ = 0;  ///< row by row
};

}  // namespace leastcost::bracket
