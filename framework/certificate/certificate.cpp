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
  visit.field("enabled", enabled, {.help = "Whether to certify the path; if false, the status is uncertified."});
  visit.choice("proof", proof,
               {.help = "When to try a proof of the local minimum, if cost and domain are formulas. needed: only if "
                        "the path would not be certified without it."});
  visit.variant("global", global,
                {.help = "Proof that no path at all costs less, where possible: on a mesh under a constant metric, for "
                         "the length among obstacles in the plane, in layers, and on a cost map read as cells. With a "
                         "budget also a bracket of the least cost in a box of the plane or of space."});
  visit.field("refine", refine,
              {.help = "How often the points may be doubled if there are too few to certify the path; the requested "
                       "number of points is delivered. 0: never.",
               .minimum = 0,
               .maximum = 16});
  visit.field("refine_work", refine_work,
              {.help = "Limit on the work of these doublings, relative to the search before them (sweeps over the "
                       "points times their number). Small searches are always allowed some doublings.",
               .minimum = 0});
  visit.field("stationarity", stationarity, {.help = "Largest relative cost error.", .minimum = 0});
  visit.field("residual", residual, {.help = "Largest distance from the domain.", .unit = "diameters", .minimum = 0});
  visit.field("spacing", spacing, {.help = "Largest max c / min c - 1, for an additive cost.", .minimum = 0});
  visit.field("doubling", doubling,
              {.help = "Largest relative deviation of E(2M) / E(4M), VFCS Eq. (8).", .minimum = 0});
  visit.field("longest_segment", longest_segment, {.help = "Largest max c / mean c.", .minimum = 1});
  visit.field("clearance", clearance,
              {.help = "Tolerance of the clearance, for rounding errors.", .unit = "diameters", .minimum = 0});
  visit.field("index_shift", index_shift,
              {.help = "Shift tau used in the two counts of the index.", .minimum = 0, .exclusive_minimum = true});
}

}  // namespace leastcost
