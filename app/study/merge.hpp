// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/study/study.hpp"

namespace leastcost::app {

struct MergeRequest {
  std::vector<std::filesystem::path> folders;  ///< of shards of one study
  std::filesystem::path output;
  bool force = false;
  std::vector<std::string> arguments;  ///< of the program, for the manifest
  std::function<void()> loaded = {};   ///< told when all files have been read; nothing has been written then
};

/// Joins the journals of shards and derives the same files as one run would have. Results that two of them hold must
/// agree but for times. What is missing is missing in the outcome's journal: see summarize(). Throws InputError for
/// folders that do not fit, OutputRefused, OutputError.
StudyOutcome merge_studies(const MergeRequest& request);

}  // namespace leastcost::app
