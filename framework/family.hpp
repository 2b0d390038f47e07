// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/find_path.hpp>

namespace leastcost {

/// One way to start: the problem (its target may be another image of the same point) and a first path.
struct FamilyStart {
  std::string origin;  ///< in words, for reports: "straight", "bow 90 degrees"
  Problem problem;
  std::shared_ptr<const Initializer> initializer;
};

/// One locally least-cost path, saddle or failure, and where it came from.
struct FamilyMember {
  std::vector<std::string> origins;  ///< every start that led to it
  Problem problem;
  Result result;
  /// What it is ranked by: the cost of a curve on the domain, of a certified path its value. +infinity: none is known.
  double rank_cost = std::numeric_limits<double>::infinity();
  bool left = false;  ///< a saddle from which a cheaper member was found
  bool tied = false;  ///< its bar overlaps with that of the first member, or in the first with that of another one
};

struct Family {
  /// Distinct paths by cost, whether certified or not; of those whose bars overlap with the least a certified one comes
  /// first. Interrupted solves, saddles that were left and collapsed rings come last.
  std::vector<FamilyMember> members;
  std::vector<std::string> notes;  ///< starts without a first path, and why; what was left undecided
};

/// Whether two paths are the same: their costs agree to 0.1 % (twice around is not once around), and no point of one is
/// farther from the other than three quarters of a segment.
bool same_path(const Problem& problem, const CoordinatePath& a, const CoordinatePath& b);

/// find_path() from every start, without more points than are asked for. What is cheaper than every certified path
/// without being certified itself goes on with twice the points, `certificate.refine` times at most, until it is
/// certified, or is left where it is a saddle; what is then delivered are the points that were asked for, of the finer
/// chain, as find_path() does. Where that decides nothing it stays first,
/// uncertified, and a note says so. Not done with the certificate switched off. A proof is always
/// tried of the first member only, of others where it is needed.
/// A start without a first path, or one that throws otherwise, is a note and loses no other; where none has a path the
/// exception of the first one is thrown. Throws InputError where an initializer is null. Stops
/// early, with what it has, when the monitor says so; interrupted before there was any path the family is one member
/// without a path.
Family find_family(const std::vector<FamilyStart>& starts, const Solver& solver, const FindOptions& options,
                   const Monitor& monitor = {});

}  // namespace leastcost
