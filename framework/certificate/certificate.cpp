// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <array>

#include <leastcost/framework/certificate/certificate.hpp>

namespace leastcost {

Words<ProofRule> words(ProofRule) {
  static constexpr std::array<Word<ProofRule>, 3> kWords = {
      {{ProofRule::always, "always"}, {ProofRule::needed, "needed"}, {ProofRule::never, "never"}}};
  return kWords;
}

void CertificateOptions::fields(FieldVisitor& visit) {
  visit.field("enabled", enabled, {.help = "Whether the path is certified; without it the status is uncertified."});
  visit.choice("proof", proof,
               {.help = "When a proof of the local minimum is tried, where cost and domain are formulas. needed: where "
                        "the path would be refused without it."});
  visit.variant("global", global,
                {.help = "A proof that no path at all costs less, where one can be made: under the Euclidean cost on a "
                         "mesh, or among obstacles in the plane."});
  visit.field("refine", refine,
              {.help = "How often the points may be doubled where the path is refused for want of points; what is then "
                       "delivered are the points that were asked for. 0: never.",
               .minimum = 0,
               .maximum = 16});
  visit.field("refine_work", refine_work,
              {.help = "What these doublings may take at most, in units of the work of the search before them (sweeps "
                       "over the points times their number); a small search may always take some.",
               .minimum = 0});
  visit.field("stationarity", stationarity, {.help = "Largest relative cost error.", .minimum = 0});
  visit.field("residual", residual, {.help = "Largest distance off the domain.", .unit = "diameters", .minimum = 0});
  visit.field("spacing", spacing, {.help = "Largest max c / min c - 1 where the cost is additive.", .minimum = 0});
  visit.field("doubling", doubling,
              {.help = "Largest relative deviation of E(2M) / E(4M), VFCS Eq. (8).", .minimum = 0});
  visit.field("longest_segment", longest_segment, {.help = "Largest max c / mean c.", .minimum = 1});
  visit.field(
      "clearance", clearance,
      {.help = "How far a path may come too near to an obstacle; for rounding.", .unit = "diameters", .minimum = 0});
  visit.field("index_shift", index_shift,
              {.help = "Shift tau of the two counts of the index.", .minimum = 0, .exclusive_minimum = true});
}

}  // namespace leastcost
