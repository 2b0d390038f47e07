// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Makes now what parts of a problem make only when they are asked for (HasCoarserVersion::coarser), so that it does
/// not count against a deadline. They are kept by the domain, whatever problem asks next, and take no longer than the
/// domain itself.
void prepare(const Problem& problem);

}  // namespace leastcost
