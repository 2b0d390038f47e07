// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Paths that need no obstacle to hold them: straight ones, mostly. Remembers the last one: among coordinates that are
/// places, in the same box, with the same cost, it is one again.
class OpenRest {
 public:
  /// Whether nothing would be cheaper beside a path of that cost even without obstacles. False where that is not known,
  /// and after the deadline.
  bool holds(const Problem& problem, const CoordinatePath& path, double cost, const Deadline& deadline);

 private:
  bool remembers(const Problem& problem, const ConstraintManifold& open, const Points& u) const;
  void remember(const Problem& problem, const ConstraintManifold& open, const Points& u);

  std::shared_ptr<const SegmentCost> cost_;  ///< null: none is known
  Points u_;
  Eigen::VectorXd lower_, upper_;  ///< of the box; empty without one
};

}  // namespace leastcost
