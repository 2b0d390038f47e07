// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/fields/cost_field.hpp>

namespace leastcost {

/// Some node that a move from there could end at has a value.
bool is_reached(const CostField& field, const Eigen::Vector2d& x);

/// The way down a field from a place on to the nearest of those of the field, by the values at its nodes; without
/// points where it is lost on the way.
std::vector<Eigen::Vector2d> steepest_way(const CostField& field, const Problem& problem, const Eigen::Vector2d& place);

}  // namespace leastcost
