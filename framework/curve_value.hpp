// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "framework/problem.hpp"

namespace leastcost {

/// Cost of the smooth curve through the points of a chain on a flat domain or a chart (in coordinates): on each segment the cubic through its four nearest
/// points, the line element integrated with 5-point Gauss. A feasible curve, hence an upper bound; order 4 at least where the chain
/// has 2. Where the cubic leaves the domain (beside a bound on which the points rest) its projection takes its place. Nothing where the line element
/// is singular (a bead at rest).
std::optional<double> smooth_curve_cost(const Problem& problem, const CoordinatePath& path);

}  // namespace leastcost
