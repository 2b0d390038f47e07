// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/problems/distance/distance_grid.hpp>

namespace leastcost {

/// Ability: the domain is the zero set of a sampled distance.
class HasDistanceGrid {
 public:
  virtual ~HasDistanceGrid() = default;
  virtual const DistanceGrid& grid() const = 0;
  virtual const std::vector<std::string>& notes() const = 0;  ///< what a user should know about how it was made
};

}  // namespace leastcost
