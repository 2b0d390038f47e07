// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace leastcost::bracket {

/// A way down a field winds a little, by the errors of the field: each point but the ends in the middle of itself and
/// of the middle of its neighbours, so many times. The ways stay in convex boxes.
template <class Way>
Way smoothed_way(Way way, int rounds) {
  const Eigen::Index inner = way.cols() - 2;
  if (inner < 1) return way;
  for (int k = 0; k < rounds; ++k) {
    const Way before = way;
    way.middleCols(1, inner) =
        0.5 * before.middleCols(1, inner) + 0.25 * (before.leftCols(inner) + before.rightCols(inner));
  }
  return way;
}

}  // namespace leastcost::bracket
