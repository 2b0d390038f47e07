// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/reference_cost.hpp"

#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {

void set_reference_cost(const Search& search, Outcome& out) {
  Result& result = out.result;
  PathEnergy energy(out.problem, 1, search.monitor.limit());
  result.initial_cost = energy.cost(result.initial);
  const bool any_start = out.sampled && !search.solver.moves_points() && search.finds_its_own();
  if (any_start && !std::isfinite(result.initial_cost)) result.initial_cost = energy.cost(result.first.path);
  result.reference_cost =
      search.options.reference_cost.value_or(result.initial_cost / static_cast<double>(result.initial.segment_count()));
  if (!(result.reference_cost > 0))
    throw InitializationError("the first path has cost 0: there is nothing to minimise");
  if (!std::isfinite(result.reference_cost))
    throw InitializationError("the first path has infinite cost, or its cost overflows");
}

}  // namespace leastcost
