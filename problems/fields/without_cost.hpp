// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Why no move begins at a place, with the place and the value: "at (1, 2) the formula of n is not positive: n = -3".
/// `u`: coordinates. Empty where moves have a cost, or the domain has no point there.
std::string why_without_cost(const Problem& problem, const Eigen::VectorXd& u);

/// The same of the first node that has no value for that reason, of about 20,000 that are looked at; empty where there
/// is none. `node`: the coordinates of a node, by its number.
std::string why_some_without_cost(const Problem& problem, const std::vector<double>& values,
                                  const std::function<Eigen::VectorXd(std::size_t)>& node);

/// Throws InputError for a place that paths cannot leave because its cost is not positive or not finite; says both.
void check_cost_at(const Problem& problem, const std::vector<Eigen::VectorXd>& places);

}  // namespace leastcost
