// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// The options that solvers share, said once.
inline void tolerance_field(FieldVisitor& visit, double& tolerance) {
  visit.field("tolerance", tolerance,
              {.help = "Stops at this relative cost error g' H^-1 g / (2 sum H'(s) s).",
               .unit = "relative cost error",
               .minimum = 0});
}
inline void limit_fields(FieldVisitor& visit, int& max_iterations, int& max_evaluations) {
  visit.field("max_iterations", max_iterations, {.help = "Limit on iterations.", .minimum = 1});
  visit.field("max_evaluations", max_evaluations, {.help = "Limit on energy and gradient evaluations.", .minimum = 1});
}

}  // namespace leastcost
