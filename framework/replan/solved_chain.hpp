// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include <leastcost/framework/domain/reuses_margins.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// A chain that was solved, and what it kept from obstacles: where the next solve begins.
struct SolvedChain {
  CoordinatePath path;  ///< empty: none
  KeptMargins margins;  ///< beyond the clearance, and the walls that points rested on

  /// Whether some point rested on an obstacle.
  bool is_held() const {
    return std::any_of(margins.resting.begin(), margins.resting.end(),
                       [](const auto& walls) { return !walls.empty(); });
  }
};

}  // namespace leastcost
