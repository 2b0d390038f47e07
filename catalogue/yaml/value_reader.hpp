// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/catalogue/yaml/config_value.hpp>
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// The tree of a configuration that has no text. The places of its nodes are subscripts of `name`:
/// config['solver']['tolerance']. Duplicate keys and trees that are deeper than any configuration are errors, each
/// added to `errors`.
ConfigNode read_value(const ConfigValue& value, const std::string& name, Diagnostics& errors);

}  // namespace leastcost
