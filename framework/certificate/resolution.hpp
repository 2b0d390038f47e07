// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/certificate/certificate_failure.hpp>
#include <leastcost/framework/certificate/cost_estimate.hpp>
#include <leastcost/framework/newton/refinement.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Whether cost and domain have details that the points of the chains did not see (docs/numerics.md Sec. 6.7).
enum class ResolutionVerdict {
  sampled,    ///< only at the points of the chains, of one more that is not nested with them, and along the curve
  proved,     ///< everywhere in a tube around the path, by interval arithmetic
  unresolved  ///< they have such details, or may have
};
Words<ResolutionVerdict> words(ResolutionVerdict);

/// Whether the points are close enough to speak for a curve.
struct Resolution {
  ResolutionVerdict verdict = ResolutionVerdict::sampled;  ///< what was found
  bool curve_enclosed = false;       ///< the cost of the smooth curve through the finest chain, by validated quadrature
  bool minimum_proved = false;       ///< no curve in the tube costs less than `lower`
  std::optional<double> half_width;  ///< of the tube where it is narrowest, units of the cost
  std::optional<double> lower, upper;  ///< of the least cost of all curves in the tube
  /// Of what is sampled: what is at least that wide along the path, at a random place, has a point of a chain in it
  /// with a probability of 99.9 %. Units of the cost; null: only the levels were solved.
  std::optional<double> narrowest;
};

/// A resolution, and what is wrong with it.
struct ExaminedResolution {
  Resolution resolution;                     ///< what was found
  std::vector<CertificateFailure> failures;  ///< "unresolved"
};

/// What is done for a proof.
enum class ProofEffort {
  none,
  normal,
  insist  ///< the path would be refused without it, which is worth far more
};

/// Looks for what the levels of the refinement did not see: solves a chain that is not nested with them, and where
/// cost and domain are formulas proves that the path is the cheapest in a tube around it
/// (framework/proof/calibrate.hpp). An estimate that contradicts what is proved, or that is wider, is replaced by the
/// bounds. Throws Interrupted.
ExaminedResolution examine_resolution(const Problem& problem, const CoordinatePath& chain, const Refinement& refinement,
                                      ProofEffort effort, CostEstimate& estimate, const Monitor& monitor);

}  // namespace leastcost
