// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// One way to start: the problem (its target may be another image of the same point) and a first path.
struct FamilyStart {
  std::string origin;                              ///< in words, for reports: "straight", "bow 90 degrees"
  Problem problem;                                 ///< the target may be another image of the same point
  std::shared_ptr<const Initializer> initializer;  ///< makes its first path
};

/// One locally least-cost path, saddle or failure, and where it came from.
struct FamilyMember {
  std::vector<std::string> origins;  ///< every start that led to it
  Problem problem;                   ///< the problem that it solves
  Result result;                     ///< path and certificate
  /// What it is ranked by: the cost of a curve on the domain, of a certified path its value. +infinity: none is known.
  double rank_cost = std::numeric_limits<double>::infinity();
  bool left = false;  ///< a saddle from which a cheaper member was found
  bool tied = false;  ///< its bar overlaps with that of the first member, or in the first with that of another one
};

/// Paths that are locally least, the cheapest first.
struct Family {
  /// Distinct paths by cost, whether certified or not; of those whose bars overlap with the least a certified one comes
  /// first. Interrupted solves, saddles that were left and collapsed rings come last.
  std::vector<FamilyMember> members;
  std::vector<std::string> notes;  ///< starts without a first path, and why; what was left undecided
};

}  // namespace leastcost
