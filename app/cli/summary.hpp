// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/run/run.hpp"

namespace leastcost::app {

/// A finished run for people: cost with its error, spacing, status with reasons, times, place of the files.
std::string summary_text(const WrittenRun& outcome, bool verbose);
/// The same for programs: result.json and the place of the files, one object.
std::string summary_json(const WrittenRun& outcome);

/// What a run would do.
std::string dry_run_text(const RunRequest& request, const Run& prepared);
std::string dry_run_json(const RunRequest& request, const Run& prepared);

}  // namespace leastcost::app
