// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/loaded_config.hpp"

#include <cstddef>

#include <leastcost/framework/base/said_of.hpp>

namespace leastcost {

void LoadedConfig::add_error(const std::string& key, const std::string& message) {
  const std::size_t dot = key.rfind('.');
  const std::string what =
      dot == std::string::npos ? in_quotes(key) : in_quotes(key.substr(dot + 1)) + " in " + key.substr(0, dot);
  errors.error(place_of(tree, key), said_of(what, message));
}

}  // namespace leastcost
