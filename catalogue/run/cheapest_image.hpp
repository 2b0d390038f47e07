// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/catalogue/run/run_parts.hpp>
#include "catalogue/config/run_config.hpp"

namespace leastcost {

/// A straight start does not insist on the coordinates of its target where others name the same point. Which of them is
/// cheapest is looked at without obstacles, in `open_domain`: straight lines through these tell nothing.
void take_cheapest_image(const RunConfig& config, const std::shared_ptr<const ConstraintManifold>& open_domain,
                         RunParts& out);

}  // namespace leastcost
