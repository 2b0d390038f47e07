// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

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
};

struct Family {
  std::vector<FamilyMember> members;  ///< distinct paths: certified ones first, then by cost
  std::vector<std::string> notes;     ///< starts without a first path, and why
};

/// Whether two paths are the same: their costs agree to 0.1 % (twice around is not once around), and no point of one is
/// farther from the other than three quarters of a segment.
bool same_path(const Problem& problem, const CoordinatePath& a, const CoordinatePath& b);

/// find_path() from every start. A start without a first path is a note; throws the InitializationError of the first
/// one when none has any. Stops early, with what it has, when the monitor says so; interrupted before there was any
/// path the family is one member without a path.
Family find_family(const std::vector<FamilyStart>& starts, const Solver& solver, const FindOptions& options,
                   const Monitor& monitor = {});

}  // namespace leastcost
