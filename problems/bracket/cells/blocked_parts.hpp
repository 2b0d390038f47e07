// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <type_traits>

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// One of the equal squares or cubes of a cell that level halvings of it make.
template <int N>
struct CellPart {
  int level = 0;
  Place<N> at = {};  ///< its number along each axis
  /// `upper`: 0 or 1 along each axis.
  CellPart half(const Place<N>& upper) const {
    CellPart out{level + 1, at};
    for (std::size_t k = 0; k < upper.size(); ++k) out.at[k] = 2 * out.at[k] + upper[k];
    return out;
  }
};

/// Which of 8 x 8 equal squares of a cell lie wholly within obstacles: no path is there, and nothing need be proved.
class BlockedParts {
 public:
  static constexpr int kLevels = 3;
  BlockedParts() = default;
  /// `depth` of a place: at most its distance from all places outside the obstacles, positive inside.
  BlockedParts(const std::function<double(const Eigen::Vector2d&)>& depth, const Grid<2>& grid, const Place<2>& cell);

  bool any() const { return bits_ != 0; }
  /// Of the cell: whether no path is in this part.
  bool holds(const CellPart<2>& part) const { return (~bits_ & mask(part)) == 0; }

 private:
  static std::uint64_t mask(const CellPart<2>& part);

  std::uint64_t bits_ = 0;  ///< row by row
};

/// In space no cell is cut.
struct NoBlockedParts {
  bool any() const { return false; }
  bool holds(const CellPart<3>&) const { return false; }
};

template <int N>
using Blocked = std::conditional_t<N == 2, BlockedParts, NoBlockedParts>;

}  // namespace leastcost::bracket
