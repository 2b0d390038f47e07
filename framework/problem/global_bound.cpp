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
              {.help = "Largest relative excess over the least cost at which the path still counts as proved.",
               .minimum = 1e-12,
               .maximum = 0.1});
  visit.field("max_seconds", max_seconds,
              {.help = "Time limit of the proof; default: none.", .unit = "s", .minimum = 0});
  visit.field("max_windows", max_windows,
              {.help = "Limit on windows on a mesh, tangents in the plane, or cells of a grid, about 100 bytes each; "
                       "default: 10 million, 2 million, 4 million.",
               .minimum = 1});
  visit.field("landmarks", landmarks,
              {.help = "On a mesh: number of vertices from which exact distances are computed first, to speed up every "
                       "proof; default: none, or 32 if `index` names a file that does not exist yet.",
               .minimum = 0,
               .maximum = 256});
  visit.field(
      "index", index,
      {.help = "On a mesh: file of landmarks, relative to the configuration; read if it exists, otherwise written."});
}

}  // namespace leastcost
