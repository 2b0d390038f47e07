// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace leastcost {

std::string lower_case(std::string text);

/// The whole file. Throws InputError where there is none, or where it cannot be read completely.
std::string read_content(const std::filesystem::path& file);

}  // namespace leastcost
