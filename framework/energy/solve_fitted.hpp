// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/domain/reuses_margins.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// What became of a chain, and the problem that it was solved on: where the domain fits segments, with the margins that
/// this chain needs.
struct FittedSolve {
  SolveReport report;
  Problem problem;
  /// There are too few points: what they have to keep from obstacles leaves many of them no place, so that there was no
  /// solve, or no way, so that a move of the solved chain is far longer than the others and it was fitted no further.
  bool torn = false;
  std::map<int, double> gaps = {};  ///< of the last fit (SegmentFit)
};

struct Fitting {
  double agreement = FitsSegments::kCloseFit;  ///< of FitsSegments::unfitted()
  const KeptMargins* kept = nullptr;           ///< of the last chain, where obstacles have moved a little since
};

/// Solves a chain. Where the domain fits segments, the chain and what the domain is fitted to are made to agree.
FittedSolve solve_fitted(Problem problem, const Solver& solver, double reference_cost, CoordinatePath& path,
                         const Monitor& monitor, const Fitting& fitting = {});

}  // namespace leastcost
