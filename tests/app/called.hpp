// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/command_line.hpp"

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

}  // namespace leastcost::test
