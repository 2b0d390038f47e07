// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// One solved level of the refinement M, 2M, 4M.
struct RefinementLevel {
  int segments = 0;      ///< of the chain of this level
  double cost = 0;       ///< of the chain, not extrapolated
  double energy = 0;     ///< at the reference cost of the middle level
  double spacing = 0;    ///< relative spread of the costs of segments
  int iterations = 0;    ///< steps of its solve
  long evaluations = 0;  ///< energies, gradients and Hessians of its solve
};

/// The path solved again with M, 2M and 4M segments, M = max(4, ceil(N / 2)): for even N >= 8 these are N/2, N, 2N.
/// Where the domain fits segments M = N.
struct Refinement {
  std::vector<RefinementLevel> levels;                             ///< with M, 2M and 4M segments
  std::vector<CoordinatePath> paths;                               ///< the solved chains
  std::vector<std::shared_ptr<const ConstraintManifold>> domains;  ///< that they were solved on, fitted to them
  std::optional<double>
      coarser;  ///< cost of the chain with half as many segments as the first level, where that could be solved
  int coarser_segments = 0;  ///< of that chain; 0: none
  bool collapsed = false;    ///< a ring that shrinks to a point, or is one
  std::string trouble;       ///< why it is incomplete, or which level did not converge; empty: all is well
};
/// The cost of a chain with another number of segments, solved from the same path; nothing where that fails. Throws
/// Interrupted.
std::optional<double> solved_cost(const Problem& problem, const CoordinatePath& chain, int segments,
                                  const Monitor& monitor);

/// Which levels are made, and when they end.
struct RefinementPlan {
  bool by_order = true;    ///< the levels will be judged by the order at which their costs fall: with the coarser chain
  bool is_solved = false;  ///< the chain is: on a domain that is fitted to it, it is the first level as it stands
};

/// Throws Interrupted after the monitor's deadline.
Refinement refine_levels(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor,
                         const RefinementPlan& plan = {});

}  // namespace leastcost
