// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What is known of the planners without their library: a program that loads the library late is linked with this alone.
#include <ompl/config.h>

#include <array>

#include <leastcost/ompl/ompl_initializer.hpp>

namespace leastcost {

Words<OmplPlanner> words(OmplPlanner) {
  static constexpr std::array<Word<OmplPlanner>, 20> kWords = {{{OmplPlanner::rrt_connect, "RRTConnect"},
                                                                {OmplPlanner::rrt, "RRT"},
                                                                {OmplPlanner::lazy_rrt, "LazyRRT"},
                                                                {OmplPlanner::trrt, "TRRT"},
                                                                {OmplPlanner::est, "EST"},
                                                                {OmplPlanner::bi_est, "BiEST"},
                                                                {OmplPlanner::kpiece, "KPIECE1"},
                                                                {OmplPlanner::bkpiece, "BKPIECE1"},
                                                                {OmplPlanner::lbkpiece, "LBKPIECE1"},
                                                                {OmplPlanner::sbl, "SBL"},
                                                                {OmplPlanner::stride, "STRIDE"},
                                                                {OmplPlanner::pdst, "PDST"},
                                                                {OmplPlanner::prm, "PRM"},
                                                                {OmplPlanner::lazy_prm, "LazyPRM"},
                                                                {OmplPlanner::fmt, "FMT"},
                                                                {OmplPlanner::bfmt, "BFMT"},
                                                                {OmplPlanner::prm_star, "PRMstar"},
                                                                {OmplPlanner::rrt_star, "RRTstar"},
                                                                {OmplPlanner::informed_rrt_star, "InformedRRTstar"},
                                                                {OmplPlanner::bit_star, "BITstar"}}};
  return kWords;
}

void OmplOptions::fields(FieldVisitor& visit) {
  visit.choice("planner", planner,
               {.help = "Planner of OMPL; those from PRMstar on improve their path until max_seconds have passed."});
  visit.field("max_seconds", max_seconds,
              {.help = "Time after which the planner gives up.",
               .unit = "s",
               .minimum = 0,
               .maximum = kMostSeconds,
               .exclusive_minimum = true});
  visit.field(
      "range", range,
      {.help = "Longest move that a planner adds at once; default: for a robot 1/8 of the distance between the ends, "
               "else OMPL's choice for the space.",
       .unit = "length",
       .minimum = 0,
       .exclusive_minimum = true});
  visit.field(
      "step", step,
      {.help = "Moves are checked in pieces of half this length; default: 1/16 of the distance between the ends.",
       .unit = "length",
       .minimum = 0,
       .exclusive_minimum = true});
  visit.field("reach", reach,
              {.help = "How far beyond the ends samples are taken along unbounded coordinates, in units of the "
                       "distance between the ends.",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field("shortcuts", shortcuts, {.help = "Number of random shortcuts tried on the path found.", .minimum = 0});
  visit.field("seed", seed, {.help = "Seed of the planner; default: the seed of the run.", .minimum = 0});
}

std::string ompl_version() {
  return std::to_string(OMPL_MAJOR_VERSION) + "." + std::to_string(OMPL_MINOR_VERSION) + "." +
         std::to_string(OMPL_PATCH_VERSION);
}

}  // namespace leastcost
