// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/end_options.hpp>
#include <leastcost/catalogue/plugins/externals.hpp>
#include <leastcost/catalogue/run/run.hpp>
#include <leastcost/catalogue/yaml/config_value.hpp>
#include <leastcost/catalogue/yaml/diagnostics.hpp>
#include <leastcost/catalogue/yaml/override.hpp>
#include <leastcost/problems/distance/build_progress.hpp>

namespace leastcost {

/// Reads, checks and composes; all files of the configuration have been read afterwards. `progress` hears of domains
/// that take a while to make, and may throw to stop. Throws ConfigError with every error and its place, InputError.
/// `externals`: objects that the configuration names as {type: external, name: ...}. `ends`: of the caller: the parts
/// of the run have no ends where the configuration lacks one; they are put in before solve().
Run load_run(const std::filesystem::path& file, const std::vector<Override>& overrides = {},
             const BuildProgress& progress = {}, const Externals& externals = {},
             EndsFrom ends = EndsFrom::configuration);

/// The same for a configuration that is in memory. `name`: what messages call it, and the default name of the run;
/// `folder`: what its files are relative to, empty for the current one.
Run parse_run(std::string text, const std::string& name, const std::filesystem::path& folder = {},
              const std::vector<Override>& overrides = {}, const BuildProgress& progress = {},
              const Externals& externals = {}, EndsFrom ends = EndsFrom::configuration);
/// The same for values that have no text; messages say config['solver']['tolerance'] where `name` is "config".
Run parse_run(const ConfigValue::Block& tree, const std::string& name, const std::filesystem::path& folder = {},
              const std::vector<Override>& overrides = {}, const BuildProgress& progress = {},
              const Externals& externals = {}, EndsFrom ends = EndsFrom::configuration);

}  // namespace leastcost
