// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/app/app.hpp>

#include <string>
#include <vector>

#include "app/cli/command_line.hpp"
#include "app/cli/heap.hpp"
#include "app/cli/process.hpp"

namespace leastcost {

int run_program(int argc, char** argv) {
  app::prepare_process();
  app::prepare_heap();
  std::vector<std::string> arguments(argv, argv + argc);
  if (arguments.empty()) arguments.emplace_back("leastcost");
  return app::run_program(arguments, app::standard_streams());
}

}  // namespace leastcost
