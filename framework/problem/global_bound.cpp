// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/problem/global_bound.hpp>

namespace leastcost {

Words<BoundCategory> words(BoundCategory) {
  static constexpr std::array<Word<BoundCategory>, 3> kWords = {
      {{BoundCategory::proved, "proved"},
       {BoundCategory::proved_given_bounds, "proved_given_bounds"},
       {BoundCategory::sampled, "sampled"}}};
  return kWords;
}

void GlobalBudget::fields(FieldVisitor& visit) {
  visit.field("tolerance", tolerance,
              {.help = "By which part of its cost the path may be above the least one and count as proved.",
               .minimum = 1e-12,
               .maximum = 0.1});
  visit.field("max_seconds", max_seconds, {.help = "Time for it; default: no limit.", .unit = "s", .minimum = 0});
  visit.field(
      "max_windows", max_windows,
      {.help = "Windows on a mesh that it may look at, or tangents in the plane, or cells of a grid, about 100 bytes "
               "each; default: 10 million, 2 million, 4 million.",
       .minimum = 1});
  visit.field("landmarks", landmarks,
              {.help = "On a mesh, exact distances from so many vertices are made first and quicken every proof; "
                       "default: none, or 32 where an index is named that is not there yet.",
               .minimum = 0,
               .maximum = 256});
  visit.field(
      "index", index,
      {.help =
           "On a mesh, file of landmarks, relative to the configuration: read where it is there, written where not."});
}

}  // namespace leastcost
