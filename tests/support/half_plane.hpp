// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include <leastcost/framework/cost/segment_cost_function.hpp>

namespace leastcost::test {

/// Upper half-plane, |b - a| over the height at the middle: a cost as a user would write it.
struct HalfPlane {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "length"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const S y = (a[1] + b[1]) * 0.5;
    if (!(innermost(y) > 0)) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() / (y * y);
  }
};

}  // namespace leastcost::test
