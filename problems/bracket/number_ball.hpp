// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <leastcost/framework/numbers/interval.hpp>
#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// Number within an interval, and what the interval adds to it.
struct Ball {
  double middle, radius;
  explicit Ball(const Interval& x) : middle(x.middle()), radius(std::max(x.hi - middle, middle - x.lo) * (1 + kEps)) {}
};

}  // namespace leastcost::bracket
