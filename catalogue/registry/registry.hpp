// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "catalogue/plugins/plugin.hpp"

namespace leastcost {

/// Everything that the library has for configurations: kind by kind (built_in.hpp).
std::vector<PluginKind> built_in_kinds();

/// Everything that a configuration can name: that, then what the program has registered until now (register.hpp). The
/// reference stays valid; it does not see later registrations.
const std::vector<PluginKind>& plugin_kinds();

/// The kind with this name or plural; null when there is none.
const PluginKind* find_kind(std::string_view name);
/// The same for a name that is known to exist.
const PluginKind& kind(std::string_view name);
/// The plug-in of a kind, null when there is none.
const PluginEntry* find_plugin(const PluginKind& kind, std::string_view type);
/// All types of a kind, in the order of registration.
std::vector<std::string> types_of(const PluginKind& kind);

}  // namespace leastcost
