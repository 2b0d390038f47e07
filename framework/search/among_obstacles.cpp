// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/among_obstacles.hpp"

#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// A path on the other side of an obstacle than the one that was begun with is not what was asked for, unless it is
/// shown to be the least of its class. Where the fit to the obstacles did not end, that is why the path fails.
void judge_homotopy_class(const Search& search, Outcome& out) {
  const Problem& problem = out.solved;
  Result& result = out.result;
  if (!search.options.certificate.enabled) return;
  const auto* obstacles = find_ability<ChecksMoves>(*problem.manifold);
  if (obstacles == nullptr) return;
  auto& failures = result.certificate.failures;
  if (!failures.empty() && result.solve.cycling)
    failures.push_back(
        {Failure::active_set_cycling, "the margins of the points from obstacles kept changing with the solution"});
  if (problem.ring || result.curve.least_of_class) return;
  const Points first = positions(*problem.manifold, result.first.path);
  if (!obstacles->same_class(first, result.curve.x).value_or(true))
    failures.push_back({Failure::class_lost, "the path passes an obstacle on a different side from the first path"});
}

}  // namespace leastcost
