// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/graph/lattice_route.hpp"

namespace leastcost {

std::vector<LatticeStep> steps_of(const Lattice& lattice) {
  std::vector<LatticeStep> steps;
  const auto wide = [&](std::size_t axis) { return lattice.count[axis] > 1 ? 1 : 0; };
  for (std::int32_t z = -wide(2); z <= wide(2); ++z)
    for (std::int32_t y = -wide(1); y <= wide(1); ++y)
      for (std::int32_t x = -wide(0); x <= wide(0); ++x)
        if (x != 0 || y != 0 || z != 0) steps.push_back({x, y, z});
  return steps;
}

}  // namespace leastcost
