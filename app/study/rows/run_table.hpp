// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/study/rows/run_row.hpp"

namespace leastcost::app {

/// runs.csv as a whole.
struct RunTable {
  std::vector<std::string> swept_keys;  ///< further columns, between `seed` and `outcome`
  std::vector<RunRow> rows;
};

/// RFC 4180. Numbers with 17 digits, so that they read back as the same ones; nan, inf and -inf spelled so.
std::string runs_csv(const RunTable& table);
std::string traces_csv(const std::vector<TraceRow>& rows);

/// `name`: of the file, for messages. Throws InputError with the line where a column is missing or a number is none.
RunTable read_runs_csv(const std::string& text, const std::string& name);
std::vector<TraceRow> read_traces_csv(const std::string& text, const std::string& name);

}  // namespace leastcost::app
