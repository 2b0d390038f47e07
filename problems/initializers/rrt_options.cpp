// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/rrt_options.hpp>

namespace leastcost {

void RrtOptions::fields(FieldVisitor& visit) {
  visit.field("step", step,
              {.help = "Length of an edge of the tree; default: a sixteenth of the distance of the ends.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field(
      "shell", shell,
      {.help = "How far nodes may be off the domain; default: a quarter of the step.", .unit = "length", .minimum = 0});
  visit.field("goal_bias", goal_bias, {.help = "Share of samples that are the other end.", .minimum = 0, .maximum = 1});
  visit.field("reach", reach,
              {.help = "How far beyond the tree samples are taken, in distances of the ends.",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field("max_nodes", max_nodes, {.help = "Nodes of both trees after which the search gives up.", .minimum = 1});
  visit.field("shortcuts", shortcuts, {.help = "Random shortcuts that are tried on the path found.", .minimum = 0});
  visit.field("paths", paths,
              {.help = "How many paths are looked for, of which the shortest is taken; default: 8 among obstacles in "
                       "space, else 1.",
               .minimum = 1});
  visit.field("seed", seed, {.help = "Seed of the samples; default: the seed of the run.", .minimum = 0});
}

}  // namespace leastcost
