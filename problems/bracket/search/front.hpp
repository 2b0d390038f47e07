// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace leastcost::bracket {

/// What a potential is marched from: values at seeds, and the density, which corrections change. `sign`: per node;
/// empty: all 1. `order`: of the nodes in the first march, which the others follow; empty where the cost depends on the
/// direction, for then no order is right.
struct Front {
  std::vector<int> seeds;
  std::vector<double> values;  ///< at the seeds, infinite elsewhere
  std::vector<double> density;
  std::vector<signed char> sign;
  std::vector<int> order;
  bool reversed = false;  ///< of costs to the seeds, not from them
};

}  // namespace leastcost::bracket
