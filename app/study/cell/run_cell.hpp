// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "app/study/grid/grid.hpp"
#include "app/study/rows/run_row.hpp"

namespace leastcost::app {

/// The row of a cell with its axes filled in and nothing else.
RunRow row_of(const StudyCell& cell, long repetition);

/// Composes and solves a cell in this process. Whatever is thrown on purpose becomes an outcome; std::bad_alloc is
/// thrown on.
CellResult run_cell(const StudyCell& cell, long repetition);

}  // namespace leastcost::app
