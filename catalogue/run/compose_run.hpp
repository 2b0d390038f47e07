// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run.hpp>
#include "catalogue/config/run_config.hpp"
#include "catalogue/inputs/input_file.hpp"
#include "catalogue/run/pair_composer.hpp"
#include "catalogue/run/run_clock.hpp"

namespace leastcost {

/// A run of a configuration that is there already and has passed its checks. Throws OptionError, InputError.
Run compose_run(const RunConfig& config, const std::filesystem::path& folder);

/// The run of parts that were composed; `why`: of the methods (why_defaults).
Run run_of(RunConfig config, std::filesystem::path folder, std::vector<InputFile> inputs, RunParts parts,
           std::vector<std::string> why, std::shared_ptr<const PairComposer> pairs, const RunStart& start);

}  // namespace leastcost
