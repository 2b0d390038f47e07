// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/study/rows/run_row.hpp"

namespace leastcost::app {

/// A result as one line of JSON without its line break: {"row": {column: value, ..}, "trace": [[iteration, ..], ..]}.
/// Numbers keep every bit; nan and the infinities are texts. Empty columns are left out.
std::string to_json_line(const CellResult& result);

/// Throws InputError (without a place) when it is no such line.
CellResult from_json_line(const std::string& line);

}  // namespace leastcost::app
