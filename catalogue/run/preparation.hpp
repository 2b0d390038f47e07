// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/catalogue/run/run_parts.hpp>
#include <leastcost/framework/domain/makes_on_demand.hpp>

namespace leastcost {

/// Whether a search asks for what prepare() makes: then it is made beforehand, as a part of loading. Where the clock
/// runs already it is not kept waiting for what a search can make within its deadline.
inline bool asks_for_preparation(const RunParts& parts, bool clock_runs) {
  if (find_ability<MakesOnDemand>(*parts.problem.manifold) != nullptr)
    return !clock_runs && parts.solver->moves_points();
  return parts.options.certificate.enabled;
}

}  // namespace leastcost
