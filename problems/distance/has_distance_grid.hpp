// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <leastcost/problems/distance/distance_grid.hpp>

namespace leastcost {

/// Ability: the domain is the zero set of a sampled distance.
class HasDistanceGrid {
 public:
  static constexpr std::string_view kAbility = "distance grid";
  virtual ~HasDistanceGrid() = default;
  virtual const DistanceGrid& grid() const = 0;  ///< the samples
};

}  // namespace leastcost
