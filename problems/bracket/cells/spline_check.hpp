// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "problems/bracket/cells/blocked_parts.hpp"
#include "problems/bracket/cells/net.hpp"

namespace leastcost::bracket {

/// What proves |grad u| <= ratio n on a cell: control vectors of the gradient, all of which lie within `ratio` times
/// the net of a function below n. Mutations of the rules are what tests call with other numbers.
template <int N>
struct CheckRules {
  double rounding = 1;            ///< times what rounding may have done to a control vector
  unsigned dropped = 0;           ///< control vectors that are not looked at, a bit each: none
  int halvings = N == 2 ? 2 : 0;  ///< of a cell whose control vectors are too long as they are
};

/// The least ratio that is proved for the spline with these coefficients on its cell of side h, where a path may be in
/// it; infinite where nothing is. `largest`: of the coefficients' sizes. Of 2 and 3 dimensions.
template <int N>
double proved_ratio(const Net<N>& coefficients, double h, double largest, const Net<N>& floor,
                    const CheckRules<N>& rules = {}, const Blocked<N>& blocked = {});

}  // namespace leastcost::bracket
