// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace leastcost::app {

/// What the results in a folder are of: "run", "study" or "pairs". Throws InputError where they are not ours.
std::string kind_of_results(const std::filesystem::path& folder);

}  // namespace leastcost::app
