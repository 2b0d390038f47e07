// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/result.hpp>
#include <leastcost/problems/initializers/bow.hpp>

namespace leastcost {

/// A way beside the straight line that costs less.
struct OtherWay {
  double cost = 0;      ///< about, cost units
  double less = 0;      ///< than the path that was found, relative
  BowOptions bow = {};  ///< a first path that leads to it
};

/// Where a path began with the straight line, under a cost that may make another way cheaper: what a few bows beside it
/// lead to, solved with few points and no certificate, then with `points`. The cheapest one, where it costs less than
/// `result` by a hundredth. Not for those who have a deadline: it takes as long as several searches.
std::optional<OtherWay> look_elsewhere(const Problem& problem, const Solver& solver, const Result& result,
                                       std::optional<int> points, const Monitor& monitor = {});

}  // namespace leastcost
