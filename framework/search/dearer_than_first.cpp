// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/dearer_than_first.hpp"

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include "framework/base/point_text.hpp"
#include "framework/result/never_worse.hpp"

namespace leastcost {

bool are_clear(const Problem& problem, const CoordinatePath& chain, double allowed, const Deadline& deadline) {
  try {
    return !(depth_in_obstacles(problem, chain, allowed, deadline) > 0);
  } catch (const Interrupted&) {
    return false;
  }
}

void refuse_dearer(const Problem& problem, const Search& search, Result& result) {
  constexpr double kDearer = 1e-5;  // relative: what the fit of those distances leaves open
  if (result.status != Status::certified || find_ability<ChecksMoves>(*problem.manifold) == nullptr) return;
  if (result.first.path.u.cols() < 2 || !moves_are_exact(problem)) return;
  if (!(result.curve.cost > result.initial_cost * (1 + kDearer))) return;
  const double first = PathEnergy(problem, 1).cost(result.first.path);
  if (!(result.curve.cost > first * (1 + kDearer))) return;
  if (!are_clear(problem, result.first.path, search.options.certificate.clearance, search.monitor.deadline)) return;
  const TwoNumbers costs = told_apart(result.curve.cost, first, 9);
  result.certificate.failures.push_back(
      {Failure::dearer_than_first, "the path costs " + costs.first + ", but the first path costs " + costs.second +
                                       ": with few points, the path must keep away from obstacles so that its moves do "
                                       "not touch them; use more points"});
  result.status = Status::uncertified;
}

}  // namespace leastcost
