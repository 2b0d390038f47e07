// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace leastcost {

/// A file that results were made from, as it was when it was read.
struct InputFile {
  std::string role;            ///< "configuration", "data" or "journal"
  std::filesystem::path file;  ///< absolute, or a name in <..> of what came without a file
  std::string sha256;
};

/// Lower-case hexadecimal SHA-256 of a file's content. Throws InputError when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);
std::string sha256_of_text(std::string_view text);

}  // namespace leastcost
