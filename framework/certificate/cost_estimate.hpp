// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/base/words.hpp>
#include <leastcost/framework/certificate/certificate_failure.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/newton/path_index.hpp>
#include <leastcost/framework/newton/refinement.hpp>

namespace leastcost {

/// Where a value and its error bar come from (docs/numerics.md Sec. 6.3).
enum class ValueMethod { unmeasured, none, exact, bracket, curve, richardson, traced, straightened, differences };
Words<ValueMethod> words(ValueMethod);

/// The reported value with its error. Units of the cost.
struct CostEstimate {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< of the least-cost curve
  double error = std::numeric_limits<double>::quiet_NaN();  ///< NaN: not measured, +infinity: nothing is known
  ValueMethod method = ValueMethod::unmeasured;             ///< how the value was found
  std::optional<double> lower;                              ///< where a bound exists
  std::optional<double> upper;                              ///< where a bound exists
  std::optional<double> order;                              ///< observed; never enters the value
};

/// An estimate, and what is wrong with it.
struct EstimatedCost {
  CostEstimate estimate;                     ///< the value with its error
  std::vector<CertificateFailure> failures;  ///< "bracket", "not_asymptotic"
};

/// Value and error bar of docs/numerics.md Sec. 6.3 from the levels, and from bounds where they exist. `energy` is that
/// of the delivered chain, `index` its verdict: bounds from below hold at a minimum only. Where a point rests on a
/// bound (`hugs_bound`) the place of contact moves between the levels and no extrapolation is regular: the bar is then
/// that of the differences. Fails as not_asymptotic where the observed order is not 2.
EstimatedCost estimate_cost(const Problem& problem, PathEnergy& energy, const CoordinatePath& chain,
                            const Refinement& refinement, const PathIndex& index, bool hugs_bound);

}  // namespace leastcost
