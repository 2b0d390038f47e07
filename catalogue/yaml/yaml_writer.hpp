// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// Text as a scalar, in quotes where YAML would otherwise take it for something else.
ConfigNode text_node(std::string_view text);

/// YAML that reads back as the same tree: blocks over lines, lists of scalars on one line.
std::string to_yaml(const ConfigNode& node);

}  // namespace leastcost
