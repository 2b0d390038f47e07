// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "app/study/rows/journal.hpp"

namespace leastcost::app {

/// Sorts the results of a journal by cell and repetition.
void sort_results(JournalContent& journal);

/// What is derived from a journal with sorted results, by file name: runs.csv, traces.csv, summary.json.
std::map<std::string, std::string> study_files(const JournalContent& journal);

/// Sorts, derives, writes each file whole. Throws OutputError.
void write_study_files(const std::filesystem::path& folder, JournalContent& journal);

}  // namespace leastcost::app
