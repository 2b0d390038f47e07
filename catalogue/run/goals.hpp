// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/catalogue/run/run_parts.hpp>
#include "catalogue/config/run_config.hpp"

namespace leastcost {

/// The ends that a target of several stands for, among the obstacles of the problem (`open_domain`: without them): its
/// points, or the configurations that bring the tool of a robot (may be null) to its pose, nearest to the source first.
/// What cannot be an end is left out, with a note. Throws OptionError where nothing is left.
std::vector<PlacedEnd> goals_of(const EndOptions& options, const Robot* robot, const ConstraintManifold& open_domain,
                                RunParts& out);

}  // namespace leastcost
