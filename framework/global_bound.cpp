// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/global_bound.hpp>

namespace leastcost {

void GlobalBudget::fields(FieldVisitor& visit) {
  visit.field("tolerance", tolerance,
              {.help = "By which part of its cost the path may be above the least one and count as proved.",
               .minimum = 1e-12,
               .maximum = 0.1});
  visit.field("max_seconds", max_seconds, {.help = "Time for it; default: no limit.", .unit = "s", .minimum = 0});
  visit.field("max_windows", max_windows,
              {.help = "Windows that it may look at, about 100 bytes each; default: 10 million.", .minimum = 1});
}

}  // namespace leastcost
