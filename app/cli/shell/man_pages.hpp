// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "app/cli/shell/command_table.hpp"

namespace leastcost::app {

/// leastcost.1 and one page for each command, leastcost-run.1, ...: file names and their text (man macros of roff).
std::map<std::string, std::string> man_pages(const CommandTable& table, const std::string& version);

}  // namespace leastcost::app
