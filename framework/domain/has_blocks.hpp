// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Coordinates of a domain that belong together: those of a factor of a product.
struct CoordinateBlock {
  Index first = 0, size = 1;  ///< coordinates first to first + size - 1
  /// What a short move by 1 in these coordinates measures, in the unit in which people measure such a move: 2 radians
  /// for unit quaternions, whose chord is half the angle of rotation; 1 elsewhere.
  double unit = 1;
};

/// Ability of a domain: its coordinates come in blocks, one after the other, all of them in one.
class HasBlocks {
 public:
  virtual ~HasBlocks() = default;
  virtual std::vector<CoordinateBlock> blocks() const = 0;  ///< which coordinates belong together: those of a factor
};

}  // namespace leastcost
