// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace leastcost {

inline constexpr std::string_view kProgramName = "leastcost";

std::string_view program_version();

struct ManifestInput {
  std::string role;            ///< "configuration" or "data"
  std::filesystem::path file;  ///< absolute
  std::string sha256;
};

struct ManifestFacts {
  std::string kind = "run";  ///< or "study"
  std::vector<std::string> arguments;
  std::vector<ManifestInput> inputs;
  int seed = 0;
  std::chrono::system_clock::time_point started, finished;
};

/// manifest.json: which program, on which machine, made these results from what.
std::string manifest_json(const ManifestFacts& facts);

/// Lower-case hexadecimal SHA-256 of a file's content. Throws InputError when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);
std::string sha256_of_text(std::string_view text);

/// "2026-05-01T12:00:00.123Z".
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace leastcost
