// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace leastcost {

/// A folder of results that is filled in its place, line by line, so that a killed program can go on in it: a study, or
/// a run of many pairs.
struct GrowingFolder {
  std::filesystem::path target;  ///< relative to the current folder
  std::string log;               ///< the file that grows: "journal.jsonl"
  std::string what;              ///< in messages: "study"
  bool force = false;            ///< begin anew where an earlier run or study has written
  bool resume = false;           ///< go on where the log ends; begin where there is none
};

/// Makes the folder, or finds the one to go on in; absolute. Throws OutputRefused where results may not be put there,
/// OutputError.
std::filesystem::path prepare_folder(const GrowingFolder& folder);

/// Removes what earlier runs and studies have written, but for the log and the manifest. What is none of ours has come
/// since the folder was looked at, and stays.
void clear_folder(const std::filesystem::path& folder, const std::string& log);

}  // namespace leastcost
