// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/cost/has_free_places.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// The cheapest way between the ends of an open path by places where moves are free, with as many segments as the path
/// has; none where the cost knows no such places, or the domain does not let it through.
std::optional<FreePassage> free_passage(const Problem& problem, const CoordinatePath& path);

/// Whether a point of the path has come to such a place.
bool reaches_free_place(const Problem& problem, const CoordinatePath& path);

/// max / min - 1 of the costs but for those of the segment that is free.
double spread_where_paid(const Eigen::VectorXd& costs, Index free);

}  // namespace leastcost
