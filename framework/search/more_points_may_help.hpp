// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// Whether every reason why a path was refused is one that more points may mend.
bool more_points_may_help(const Problem& problem, const Result& result);

/// Whether a chain was not solved, or is none that a search should end at. On a mesh also one that jumps over a fold:
/// with points between, it stays there.
bool is_astray(const Problem& problem, const Certificate& c);

}  // namespace leastcost
