// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// The unit of a cost: that which it names, and "m" for a length on the Earth whose unit is a metre of the ground, to a
/// hundredth. The ends say where.
std::string unit_of_cost(const Problem& problem);

}  // namespace leastcost
