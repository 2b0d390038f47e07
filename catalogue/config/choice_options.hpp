// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string_view>

#include "catalogue/plugins/plugin.hpp"
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// Whether a plug-in was chosen that is one of some types.
bool is_type(const PluginChoice& choice, std::initializer_list<std::string_view> types);

/// Whether a domain is R^d or a box in it, obstacles apart.
bool is_flat(const PluginChoice& manifold);

/// The options of a plug-in, as a configuration would have them; those that are not given and have no default are left
/// out.
ConfigNode options_as_tree(const PluginChoice& choice);

/// A whole number among the options of a plug-in; 0 where it has none of this name.
int whole_option(const PluginChoice& choice, std::string_view name);

}  // namespace leastcost
