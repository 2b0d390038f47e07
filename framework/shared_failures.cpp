// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/shared_failures.hpp"

#include "framework/point_text.hpp"

namespace leastcost {

void fail_spacing(Certificate& c, double allowed) {
  c.failures.push_back({"spacing", "max / min cost of a segment exceeds 1 by " + short_number(c.spacing) +
                                       "; allowed " + short_number(allowed)});
}

void check_stationarity(Certificate& c, double allowed) {
  if (*c.stationarity <= allowed) return;
  c.failures.push_back({"stationarity", "the relative cost error is " + short_number(*c.stationarity) + "; allowed " +
                                            short_number(allowed) + ": the solver has not converged"});
}

}  // namespace leastcost
