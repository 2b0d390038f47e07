// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Whether two paths are the same: their costs agree to 0.1 % (twice around is not once around), and no point of one is
/// farther from the other than three quarters of a segment.
bool same_path(const Problem& problem, const CoordinatePath& a, const CoordinatePath& b);

}  // namespace leastcost
