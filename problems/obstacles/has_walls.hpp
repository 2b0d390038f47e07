// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// Ability of a domain whose walls can be asked for: how near a place is to what.
class HasWalls {
 public:
  virtual ~HasWalls() = default;
  virtual const Walls& walls() const = 0;  ///< what keeps points out
};

}  // namespace leastcost
