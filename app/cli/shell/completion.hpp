// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/cli/shell/command_table.hpp"

namespace leastcost::app {

/// Scripts that complete commands, options, their values, types of plug-ins and files. None needs the program, or
/// bash-completion, when it runs.
std::string bash_completion(const CommandTable& table);
std::string zsh_completion(const CommandTable& table);
std::string fish_completion(const CommandTable& table);

}  // namespace leastcost::app
