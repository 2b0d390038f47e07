// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/cost/segment_cost.hpp>

#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

Eigen::VectorXd segment_costs(const SegmentCost& cost, const AmbientPath& path) {
  Eigen::VectorXd c(path.segment_count());
  cost.squared_costs(path, {c.data(), static_cast<std::size_t>(c.size())});
  return c.cwiseSqrt();
}

double total_cost(const SegmentCost& cost, const AmbientPath& path) { return segment_costs(cost, path).sum(); }

double move_cost(const SegmentCost& cost, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  if (a.size() != cost.dim() || b.size() != cost.dim())
    throw InputError("a move of this cost must join two points of dimension " + std::to_string(cost.dim()));
  Points ends(a.size(), 2);
  ends << a, b;
  double q = 0;
  cost.squared_costs({{ends.data(), ends.rows(), 2}, {}, false}, {&q, 1});
  return std::sqrt(q);
}

std::string reason_for_infinity(const SegmentCost& cost, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const auto* explains = find_ability<ExplainsInfinity>(cost);
  const std::string why = explains != nullptr ? explains->why_infinite(a, b) : "";
  return why.empty() ? "" : ": " + why;
}

}  // namespace leastcost
