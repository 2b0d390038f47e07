// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/among_obstacles.hpp"

#include <limits>

#include <leastcost/framework/checks_moves.hpp>
#include <leastcost/framework/clearance.hpp>
#include <leastcost/framework/path_energy.hpp>

namespace leastcost {

double contact_tolerance(const Points& x, double allowed) {
  constexpr double kLastDigits = 64 * std::numeric_limits<double>::epsilon();  // what proofs of clearance allow, too
  const double extent = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
  return allowed * extent + kLastDigits * x.cwiseAbs().maxCoeff();
}

double depth_in_obstacles(const Problem& problem, const CoordinatePath& chain, double allowed,
                          const Deadline& deadline) {
  if (find_ability<ChecksMoves>(*problem.manifold) == nullptr) return 0;
  const Points x = positions(*problem.manifold, chain);
  const auto clearance = measure_clearance(*problem.manifold, x, chain.ring, deadline);
  return clearance && clearance->lower < -contact_tolerance(x, allowed) ? -clearance->lower : 0;
}

/// A path on the other side of an obstacle than the one that was begun with is not what was asked for, unless it is
/// shown to be the least of its class. Where the fit to the obstacles did not end, that is why the path fails.
void judge_among_obstacles(const Problem& problem, Result& result) {
  const auto* obstacles = find_ability<ChecksMoves>(*problem.manifold);
  if (obstacles == nullptr) return;
  auto& failures = result.certificate.failures;
  if (!failures.empty() && result.solve.cycling)
    failures.push_back(
        {"active_set_cycling", "what the points keep from the obstacles and where they come to rest did not agree"});
  if (problem.ring || result.curve.least_of_class) return;
  const Points first = positions(*problem.manifold, result.first.path);
  if (!obstacles->same_class(first, result.curve.x).value_or(true))
    failures.push_back({"class_lost", "the path passes an obstacle on another side than the first path"});
}

}  // namespace leastcost
