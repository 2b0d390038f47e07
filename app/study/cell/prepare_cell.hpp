// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/study/grid/grid.hpp"

namespace leastcost::app {

/// What cells that differ by solver, kernel, points or seed have in common: their domain, cost, ends and obstacles.
/// Equal for cells of which prepare_cell() has to be called for one.
std::string shared_composition(const StudyCell& cell);

/// Makes the parts of a cell that its options alone allow, so that the processes of its like inherit what is remembered
/// of it: whether a formula is a cost. Reads no file: what a damaged one may do stays in the process of its cell. The
/// parts themselves are dropped, and errors are left to the cells, whose outcome they are.
void prepare_cell(const StudyCell& cell);

}  // namespace leastcost::app
