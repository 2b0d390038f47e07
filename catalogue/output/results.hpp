// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <leastcost/catalogue/output/write_run.hpp>
#include "catalogue/options/options_writer.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost {

/// All files of a finished run into its (not yet committed) folder: result.json and path.csv first, and result.json
/// again at the end, with the time that the others took in outcome.seconds.write. `arguments`: of the program, for the
/// manifest.
void write_results(RunOutcome& outcome, const std::vector<std::string>& arguments, OutputFolder& folder);

/// What files of a configuration are called in one that lies in `output`: relative ones work from there.
RenameFile from_output(const std::filesystem::path& folder_of_config, const std::filesystem::path& output);

}  // namespace leastcost
