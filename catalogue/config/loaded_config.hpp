// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <leastcost/catalogue/yaml/diagnostics.hpp>
#include "catalogue/config/run_config.hpp"
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// A configuration file after reading.
struct LoadedConfig {
  std::filesystem::path file;    ///< empty for a text without a file
  std::filesystem::path folder;  ///< files of the configuration are relative to it
  std::string text;
  ConfigNode tree;           ///< overrides included: where each option stands
  Place place{1, 1, 1, ""};  ///< of the tree as a whole: where missing keys are reported
  RunConfig config;
  Diagnostics errors;  ///< what was found so far; config is usable only while it is empty

  /// An error of an object made from the configuration (key: its path, "cost.matrix") at its place.
  void add_error(const std::string& key, const std::string& message);
};

}  // namespace leastcost
