// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include <leastcost/app/report/page/report_file.hpp>

namespace leastcost::app {

/// report.html of a study and its figures as SVG files, from runs.csv, traces.csv, summary.json and manifest.json.
/// Throws InputError.
std::vector<ReportFile> study_report(const std::filesystem::path& folder);

}  // namespace leastcost::app
