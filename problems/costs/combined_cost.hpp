// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// A part of a sum of costs.
struct WeightedCost {
  double weight = 1;                        ///< > 0
  std::shared_ptr<const SegmentCost> cost;  ///< one of the costs that are added
};

/// c(a, b) = sum_k w_k c_k(a, b), of costs of the same dimension. Symmetric, additive, below curves where all parts
/// are. Where all parts are lengths under multiples of one metric (refractive indices, travel times, a constant metric:
/// HasConformalMetric) it is one too, and certificates can be proved; elsewhere it is a Finsler cost, whose square is
/// not twice differentiable at a = b (`quadratic_at_rest` is false). Where all are one constant metric, so is the sum.
/// Follows the data of the domain where a part does. A part with interfaces (HasInterfaces) or a regularized one
/// (Regularized: walking) is refused. Throws OptionError ("terms", "terms.1.weight", "terms.1.cost").
std::shared_ptr<const SegmentCost> make_sum_cost(std::vector<WeightedCost> terms);

struct ScaleOptions {
  std::string by = {};  ///< f(x) > 0
  std::map<std::string, double> parameters = {};
  void fields(FieldVisitor& visit);
};

/// c(a, b) = f(m) c_0(a, b) with f > 0 in the middle m. Keeps what c_0 is but for exactness along a move. +infinity
/// where f is not positive. Refuses what a sum refuses. Throws OptionError ("by", "cost").
std::shared_ptr<const SegmentCost> make_scaled_cost(const ScaleOptions& options,
                                                    std::shared_ptr<const SegmentCost> cost);

}  // namespace leastcost
