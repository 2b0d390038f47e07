// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

inline constexpr std::size_t kLargestConfiguration = 1 << 20;  ///< bytes

/// The one document of a YAML text as a tree. Stricter than YAML: duplicate keys, further documents, anchors, aliases,
/// merge keys, tags, tabs in the indentation and keys that are not words are errors, each at its place, added to
/// `errors` (what could be read is returned all the same). Texts above 1 MB are refused.
ConfigNode read_yaml(std::string_view text, Diagnostics& errors);

/// The value of `--set key=value`, which is YAML on one line; all places carry `origin`.
ConfigNode read_yaml_value(std::string_view text, const std::string& origin, Diagnostics& errors);

}  // namespace leastcost
