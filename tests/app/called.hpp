// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

/// What a command of the program leaves, called inside this process.
struct Called {
  int exit;
  std::string out, err;
};

inline Called call(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "leastcost");
  std::ostringstream out, err;
  const int exit = app::run_program(arguments, {out, err});
  return {exit, out.str(), err.str()};
}

/// Writes a file for such a command, and returns its name.
inline std::string text_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file.string();
}

/// The numbers of a .npy file of doubles, in their order: of a lattice the northernmost row first.
inline std::vector<double> npy_numbers(const std::filesystem::path& file) {
  constexpr std::size_t kHeader = 128;
  const std::string bytes = content(file);
  REQUIRE(bytes.size() > kHeader);
  std::vector<double> numbers((bytes.size() - kHeader) / sizeof(double));
  std::memcpy(numbers.data(), bytes.data() + kHeader, numbers.size() * sizeof(double));
  return numbers;
}

}  // namespace leastcost::test
