// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/externals.hpp>
#include <leastcost/catalogue/yaml/config_value.hpp>
#include <leastcost/catalogue/yaml/override.hpp>
#include "catalogue/config/loaded_config.hpp"

namespace leastcost {

/// Reads and checks. All errors are in `errors`; throws InputError only when the file cannot be read.
LoadedConfig load_config(const std::filesystem::path& file, const std::vector<Override>& overrides,
                         const Externals& externals = {}, EndsFrom ends = EndsFrom::configuration);
LoadedConfig parse_config(std::string text, const std::string& file_name, const std::filesystem::path& folder,
                          const std::vector<Override>& overrides = {}, const Externals& externals = {},
                          EndsFrom ends = EndsFrom::configuration);
/// The same for values in memory. `name`: what messages subscript.
LoadedConfig parse_config(const ConfigValue::Block& tree, const std::string& name, const std::filesystem::path& folder,
                          const std::vector<Override>& overrides = {}, const Externals& externals = {},
                          EndsFrom ends = EndsFrom::configuration);

/// Reads `tree` into `config` and checks it. Done by those above; `name`: of a run that has none.
void read_tree(LoadedConfig& loaded, const std::string& name, const Externals& externals = {},
               EndsFrom ends = EndsFrom::configuration);
/// The text of a configuration file. Throws InputError. Of a text that is too long for a configuration no more is read
/// than shows it: a device may have no end.
std::string config_text(const std::filesystem::path& file);
std::string config_text(std::istream& in);

}  // namespace leastcost
