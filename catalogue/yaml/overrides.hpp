// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <leastcost/catalogue/yaml/override.hpp>
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// Overrides as the command line gives them: messages show "--set solver.max_iterations=50".
Override set_option(const std::string& assignment);
Override seed_option(const std::string& number);

/// Replaces or adds what each override names, in order. Blocks on the way are made where there are none; a plug-in that
/// is given as a word (cost: euclidean) becomes a block with that type. Numbers in a path are positions in a list, from
/// 0.
void apply_overrides(const std::vector<Override>& overrides, ConfigNode& root, Diagnostics& errors);

/// The same for one option whose value is there already. `place`: where the path is written.
void put_option(const std::string& path, ConfigNode value, const Place& place, ConfigNode& root, Diagnostics& errors);

}  // namespace leastcost
