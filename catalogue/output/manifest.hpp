// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/inputs/input_file.hpp"

namespace leastcost {

inline constexpr std::string_view kProgramName = "leastcost";

std::string_view program_version();

struct ManifestFacts {
  std::string kind = "run";  ///< or "study"
  std::vector<std::string> arguments;
  std::vector<InputFile> inputs;
  int seed = 0;
  std::chrono::system_clock::time_point started, finished;
};

/// manifest.json: which program, on which machine, made these results from what.
std::string manifest_json(const ManifestFacts& facts);

/// "2026-05-01T12:00:00.123Z".
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace leastcost
