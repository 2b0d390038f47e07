// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// What an interrupted result lacks for want of time: its costs and its curve, by the post-processors of `options`
/// where they can be applied without improving the path. Takes as long as it takes; other results stay as they are.
void complete_interrupted(const Problem& problem, const FindOptions& options, Result& result);

}  // namespace leastcost
