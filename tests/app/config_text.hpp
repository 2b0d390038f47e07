// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "catalogue/config/load_config.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/yaml/overrides.hpp"

namespace leastcost::test {

/// A configuration of a straight line in the plane; tests add to it or break it.
inline const std::string kPlane = R"(manifold: {type: euclidean, dimension: 2}
cost: euclidean
ends:
  source: {point: [0, 0]}
  target: {point: [3, 4]}
)";

inline LoadedConfig parse(const std::string& text, const std::vector<std::string>& set = {}) {
  std::vector<Override> overrides;
  overrides.reserve(set.size());
  for (const std::string& assignment : set) overrides.push_back(set_option(assignment));
  return parse_config(text, "a.yaml", ".", overrides);
}

/// All errors as the program prints them, those of constructors included.
inline std::string errors_of(const std::string& text, const std::vector<std::string>& set = {}) {
  LoadedConfig loaded = parse(text, set);
  if (loaded.errors.empty()) check_parts(loaded);
  return loaded.errors.render();
}

}  // namespace leastcost::test
