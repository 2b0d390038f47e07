// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace leastcost::app {

/// report.html of a run, from the files of its folder. Throws InputError.
std::string run_report(const std::filesystem::path& folder);

}  // namespace leastcost::app
