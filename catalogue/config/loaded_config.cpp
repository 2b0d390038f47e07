// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/loaded_config.hpp"

#include <cstddef>

#include <leastcost/framework/base/said_of.hpp>

namespace leastcost {

void LoadedConfig::add_error(const std::string& key, const std::string& message) {
  const std::size_t dot = key.rfind('.');
  const std::string last = key.substr(dot + 1);  // npos + 1 is 0
  const std::string block = dot == std::string::npos ? "" : key.substr(0, dot);
  // An entry of a list has no name of its own.
  const std::string what = list_index(last) && !block.empty() ? in_quotes(shown_path(key))
                           : block.empty()                    ? in_quotes(key)
                                                              : in_quotes(last) + " in " + shown_path(block);
  const Place at = place_of(tree, key);
  // A place in Python, config['cost']['file'], has named the option.
  const bool named = at.origin.ends_with("['" + last + "']");
  errors.error(at, named ? message : said_of(what, message));
}

}  // namespace leastcost
