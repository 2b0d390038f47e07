// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/run/compose.hpp"
#include "catalogue/run/load_run.hpp"
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

/// The text with a part of it, which must be there, replaced once.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument("nothing to replace: " + from);
  return text.replace(at, from.size(), to);
}

/// Why a run with files of this folder is refused; empty: it is not.
inline std::string refusal_of(const std::string& text, const std::filesystem::path& folder) {
  try {
    parse_run(text, "a.yaml", folder);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace leastcost::test
