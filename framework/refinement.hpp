// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/certificate.hpp>

namespace leastcost {

/// The path solved again with M, 2M and 4M segments, M = max(4, ceil(N / 2)): for even N >= 8 these are N/2, N, 2N.
struct Refinement {
  std::vector<RefinementLevel> levels;
  std::vector<CoordinatePath> paths;
  std::optional<double>
      coarser;  ///< cost of the chain with half as many segments as the first level, where that could be solved
  int coarser_segments = 0;
  bool collapsed = false;  ///< a ring that shrinks to a point, or is one
  std::string trouble;     ///< why it is incomplete, or which level did not converge; empty: all is well
};
/// Throws Interrupted after the monitor's deadline.
Refinement refine_levels(const Problem& problem, const CoordinatePath& chain, const Monitor& monitor);

/// Value and error bar of docs/numerics.md Sec. 6.3 from the levels, and from bounds where they exist. `energy` is that
/// of the delivered chain, `index` its verdict: bounds from below hold at a minimum only. Where a point rests on a
/// bound
/// (`hugs_bound`) the place of contact moves between the levels and no extrapolation is regular: the bar is then that
/// of the differences. Adds the failure not_asymptotic where the observed order is not 2.
CostEstimate estimate_cost(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain,
                           const Refinement& refinement, const PathIndex& index, bool hugs_bound,
                           std::vector<CertificateFailure>& failures);

}  // namespace leastcost
