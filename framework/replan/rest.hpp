// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/sees_bounds.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/replan/solved_chain.hpp>

namespace leastcost {

/// What holds a solved path: bounds beside its points. As long as these stay where they are, and the cost is the same
/// object, the path stays a solution, whatever else moves, unless something moves onto it.
class Rest {
 public:
  Rest() = default;
  /// Of the bounds beside points only those count that hold them, if the path is the chain that was solved.
  Rest(const Problem& problem, const CoordinatePath& path, const SolvedChain& solved);
  /// Whether nothing that held the path has moved. False where that is not known.
  bool holds(const Problem& problem, const CoordinatePath& path) const;

 private:
  std::shared_ptr<const SegmentCost> cost_;
  Points u_;
  double reach_ = 0;
  Eigen::VectorXd lower_, upper_;               ///< of the box that the points are in; empty: none
  std::vector<std::vector<NearBound>> beside_;  ///< of the free points
};

}  // namespace leastcost
