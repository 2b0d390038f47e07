// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// Whether two ends are one place but for rounding: their coordinates differ by a few units in the last place of the
/// largest of them at most. Nothing between them could be told from them.
inline bool equal_up_to_rounding(const PathEnd& a, const PathEnd& b) {
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();  // of the largest coordinate
  if (a.u.size() != b.u.size() || a.u.size() == 0 || a.site != b.site) return false;
  const double largest = std::max(a.u.cwiseAbs().maxCoeff(), b.u.cwiseAbs().maxCoeff());
  return (a.u - b.u).cwiseAbs().maxCoeff() <= kRounding * largest;
}

}  // namespace leastcost
