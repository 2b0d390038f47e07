// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/certificate/shared_failures.hpp"

#include "framework/base/point_text.hpp"

namespace leastcost {

void fail_spacing(Certificate& c, double allowed) {
  const TwoNumbers texts = told_apart(c.spacing, allowed);
  c.failures.push_back(
      {Failure::spacing, "max / min cost of a segment exceeds 1 by " + texts.first + "; allowed " + texts.second});
}

void check_stationarity(Certificate& c, double allowed) {
  if (*c.stationarity <= allowed) return;
  const TwoNumbers texts = told_apart(*c.stationarity, allowed);
  c.failures.push_back({Failure::stationarity, "the relative cost error is " + texts.first + "; allowed " +
                                                   texts.second + ": the solver has not converged"});
}

}  // namespace leastcost
