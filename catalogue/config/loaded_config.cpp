// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/loaded_config.hpp"

#include <cstddef>

#include <leastcost/framework/base/said_of.hpp>

namespace leastcost {

void LoadedConfig::add_error(const std::string& key, const std::string& message) {
  const std::size_t dot = key.rfind('.');
  const std::string last = key.substr(dot + 1);  // npos + 1 is 0
  const std::string what = dot == std::string::npos ? in_quotes(key) : in_quotes(last) + " in " + key.substr(0, dot);
  const Place at = place_of(tree, key);
  // A place in Python, config['cost']['file'], has named the option.
  const bool named = at.origin.ends_with("['" + last + "']");
  errors.error(at, named ? message : said_of(what, message));
}

}  // namespace leastcost
