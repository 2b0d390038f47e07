// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/cli/streams.hpp"

namespace leastcost::app {

/// The whole program but for main(): parses the arguments (those[0] is the program's name), runs the command, returns
/// the exit code. Never throws.
int run_program(const std::vector<std::string>& arguments, const Streams& streams);

}  // namespace leastcost::app
