// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/search/result.hpp>

namespace leastcost {

/// Adds to the failures of a certificate what the obstacles of the domain, if there are any, did to the path.
void judge_among_obstacles(const Problem& problem, Result& result);

}  // namespace leastcost
