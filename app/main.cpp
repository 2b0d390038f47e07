// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.hpp"
#include "app/cli/process.hpp"

int main(int argc, char** argv) {
  leastcost::app::prepare_process();
  const std::vector<std::string> arguments(argv, argv + argc);
  return leastcost::app::run_program(arguments, leastcost::app::standard_streams());
}
