// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/plugins/plugin.hpp"

#include <algorithm>

namespace leastcost {

bool PluginChoice::provides(std::string_view ability) const {
  return plugin != nullptr && std::count(plugin->provides.begin(), plugin->provides.end(), ability) > 0;
}

PluginChoice choose(const PluginEntry& plugin, std::string path) {
  return {&plugin, std::shared_ptr<AnyOptions>(plugin.defaults()), std::move(path)};
}

}  // namespace leastcost
