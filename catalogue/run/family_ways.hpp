// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/catalogue/run/run_parts.hpp>
#include "catalogue/config/run_config.hpp"

namespace leastcost {

/// Adds the further ways of a family to `out`: bows, the mirror image, routes, and `others`, the initializers that the
/// family lists.
void add_family_ways(const RunConfig& config, const std::vector<std::shared_ptr<const Initializer>>& others,
                     RunParts& out);

/// The starts of a family: every image of the target, from the run's own initializer and the further ways.
std::vector<FamilyStart> family_starts(const RunParts& parts);

}  // namespace leastcost
