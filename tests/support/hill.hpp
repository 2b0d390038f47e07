// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <leastcost/framework/cost/segment_cost_function.hpp>

namespace leastcost::test {

/// docs/oracles.md D3: a hill of the refractive index, n = 1 + 2 exp(-r^2). Between ends on opposite sides: two mirror
/// minima around it, a saddle over its top.
struct Hill {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "weighted length"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::exp;
    const S weight = S(1.0) + 2 * exp(S(-((a + b) * S(0.5)).squaredNorm()));
    return (b - a).squaredNorm() * weight * weight;
  }
};

}  // namespace leastcost::test
