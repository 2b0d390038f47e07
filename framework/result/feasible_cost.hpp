// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// What a curve on the domain through the points of a result costs: an upper bound of the least cost, whatever else
/// failed. The bound of the certificate where it has one, the chain itself where its moves stay on the domain, a
/// smooth curve through the points in a flat domain or a chart, elsewhere the chain with eight times the points,
/// projected. +infinity where no such curve is known: the path is empty, collapsed, or jumps. Throws Interrupted.
double feasible_cost(const Problem& problem, const Result& result, const Deadline& deadline = {});

}  // namespace leastcost
