// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "app/output/manifest.hpp"
#include "app/output/output_folder.hpp"
#include "app/run.hpp"

namespace leastcost::app {

/// All files of a finished run into its (not yet committed) folder. `folder_of_config`: what its files are relative to.
void write_results(const RunOutcome& outcome, const std::filesystem::path& folder_of_config, const ManifestFacts& facts,
                   OutputFolder& folder);

/// What files of a configuration are called in one that lies in `output`: relative ones work from there.
RenameFile from_output(const std::filesystem::path& folder_of_config, const std::filesystem::path& output);

/// result.json.
std::string result_json(const RunOutcome& outcome);

}  // namespace leastcost::app
