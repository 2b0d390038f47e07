// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <leastcost/app/report/page/report_file.hpp>

namespace leastcost {

/// The report on a folder of results, made from its files alone: report.html, for a study its figures as files of their
/// own too. One self-contained page each; nothing in it asks for anything outside. Throws InputError that names the
/// file which is missing, damaged or not ours.
std::vector<ReportFile> make_report(const std::filesystem::path& folder);

/// make_report(), each file put in its place in one step, so that an old report stays until the new one is there.
/// Returns report.html. Throws InputError; OutputError when a file cannot be written.
std::filesystem::path write_report(const std::filesystem::path& folder);

}  // namespace leastcost
