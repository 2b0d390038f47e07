// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/rrt_options.hpp>

namespace leastcost {

void RrtOptions::fields(FieldVisitor& visit) {
  visit.field(
      "step", step,
      {.help = "Length of an edge of the tree; default: 1/16 of the distance between the ends; for a robot, 1/16 of "
               "the diagonal of its joint limits.",
       .unit = "length",
       .minimum = 0,
       .exclusive_minimum = true});
  visit.field("shell", shell,
              {.help = "Largest distance of a node from the domain; default: a quarter of the step.",
               .unit = "length",
               .minimum = 0});
  visit.field("goal_bias", goal_bias,
              {.help = "Share of samples placed at the other end.", .minimum = 0, .maximum = 1});
  visit.field("reach", reach,
              {.help = "How far beyond the tree samples are taken, in units of the distance between the ends.",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field("max_nodes", max_nodes,
              {.help = "Number of nodes in both trees at which the search gives up.", .minimum = 1});
  visit.field("shortcuts", shortcuts,
              {.help = "Number of random shortcuts tried on the path found; for a robot, up to ten times as many.",
               .minimum = 0});
  visit.field(
      "paths", paths,
      {.help =
           "Number of paths to find, of which the shortest is taken; default: among obstacles 8 in space and 4 in more "
           "dimensions (a robot; up to 12 if the best is far from straight), otherwise 1.",
       .minimum = 1});
  visit.field("seed", seed, {.help = "Seed of the samples; default: the seed of the run.", .minimum = 0});
}

}  // namespace leastcost
