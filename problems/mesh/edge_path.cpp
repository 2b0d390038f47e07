// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/edge_path.hpp>

namespace leastcost {

std::string EdgePath::failure() const {
  switch (outcome) {
    case EdgePathOutcome::found: return {};
    case EdgePathOutcome::different_components:
      return "the ends are in different parts of the mesh, with " + std::to_string(source_component_size) + " and " +
             std::to_string(target_component_size) +
             " vertices (`weld: true` merges vertices at equal positions, `weld: 1e-6` those no farther apart, in "
             "length units; `leastcost doctor` lists the parts and the distance)";
    case EdgePathOutcome::no_finite_route:
      return "the cost is infinite on every route along the edges (" + std::to_string(settled) + " of " +
             std::to_string(source_component_size) + " vertices can be reached)";
    case EdgePathOutcome::stopped: return "the search was stopped after " + std::to_string(settled) + " vertices";
  }
  return {};
}

}  // namespace leastcost
