// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "tests/support/data.hpp"

namespace leastcost::test {

/// Whether a program of another package is installed; without it, records the skip.
inline bool has_program(const std::string& program, const std::string& package) {
  if (std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0) return true;  // NOLINT
  record_skip(program, "not installed (Debian package " + package + ")");
  return false;
}

/// What a command of the shell prints; empty where it fails.
inline std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");  // NOLINT
  if (pipe == nullptr) return text;
  char part[4096];
  while (std::fgets(part, sizeof part, pipe) != nullptr) text += part;
  return pclose(pipe) == 0 ? text : std::string();
}

}  // namespace leastcost::test
