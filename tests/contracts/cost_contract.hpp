// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <leastcost/framework/check/check_cost.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {

/// What the contract needs to know about a cost besides the cost.
struct CostCase {
  std::shared_ptr<const SegmentCost> cost;
  std::function<Eigen::VectorXd(Random&)> draw;  ///< a point well inside the domain of the cost
  std::vector<Eigen::VectorXd> outside = {};     ///< points where a move has infinite cost
  bool linear_residual = false;                  ///< the Gauss-Newton Hessian is claimed to be the exact one
  double defect_order = 2;  ///< of (c(a, m) + c(m, b)) / c(a, b) - 1 in |b - a|, where not additive
};

/// The contract of SegmentCost (framework/cost/segment_cost.hpp), by the check that authors have as well.
inline void check_cost_contract(const CostCase& c) {
  Random random;
  CheckCostOptions options;
  options.defect_order = c.defect_order;
  options.linear_residual = c.linear_residual;
  options.outside = c.outside;
  CAPTURE(c.cost->dim(), c.cost->traits().unit);
  CHECK(text(check_cost(
            *c.cost, [&](std::mt19937_64&) { return c.draw(random); }, random.engine(), options)) == "");
}

}  // namespace leastcost::test
