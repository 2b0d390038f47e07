// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/catalogue/run/run_parts.hpp>
#include "catalogue/config/loaded_config.hpp"

namespace leastcost {

/// Why the methods are what they are that the configuration leaves open, a line each: first path, solver,
/// post-processors, proof over all paths. `parts`: as they were composed.
std::vector<std::string> why_defaults(const LoadedConfig& loaded, const RunParts& parts);

}  // namespace leastcost
