// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// clicks.json: what shortest paths between other ends need, to the last digit (problems/clicks); under `mesh` or
/// `plan`, which have `too_large`, a count, alone where that is so. Empty where there is neither.
std::string clicks_json(const Problem& problem);

}  // namespace leastcost
