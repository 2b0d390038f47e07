// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <leastcost/catalogue/output/manifest.hpp>
#include <leastcost/catalogue/output/output_folder.hpp>
#include <leastcost/catalogue/run/run.hpp>

namespace leastcost {

/// All files of a finished run into its (not yet committed) folder. `folder_of_config`: what its files are relative to.
void write_results(const RunOutcome& outcome, const std::filesystem::path& folder_of_config, const ManifestFacts& facts,
                   OutputFolder& folder);

/// What files of a configuration are called in one that lies in `output`: relative ones work from there.
RenameFile from_output(const std::filesystem::path& folder_of_config, const std::filesystem::path& output);

/// result.json.
std::string result_json(const RunOutcome& outcome);

}  // namespace leastcost
