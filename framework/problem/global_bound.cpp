// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/problem/global_bound.hpp>

namespace leastcost {

Words<BoundCategory> words(BoundCategory) {
  using enum BoundCategory;
  static constexpr Word<BoundCategory> kWords[] = {
      {proved, "proved"}, {proved_given_bounds, "proved_given_bounds"}, {sampled, "sampled"}};
  return kWords;
}

Words<Scope> words(Scope) {
  using enum Scope;
  static constexpr Word<Scope> kWords[] = {{none, ""},
                                           {local, "local"},
                                           {local_value, "local_value"},
                                           {local_on_polyhedron, "local_on_polyhedron"},
                                           {chain_on_polyhedron, "chain_on_polyhedron"},
                                           {least_of_class, "least_of_class"},
                                           {global_on_polyhedron, "global_on_polyhedron"},
                                           {global, "global"}};
  return kWords;
}

Words<ProofOutcome> words(ProofOutcome) {
  using enum ProofOutcome;
  static constexpr Word<ProofOutcome> kWords[] = {
      {proved, "proved"}, {improved, "improved"}, {sampled, "sampled"}, {bounded, "bounded"}, {blocked, "blocked"}};
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
