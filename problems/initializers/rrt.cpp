// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/rrt.hpp>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/framework/errors.hpp>
#include "problems/initializers/random_trees.hpp"

namespace leastcost {
namespace {

std::string failure(const RandomTrees& trees, const RrtOptions& options, double distance, bool interrupted) {
  std::ostringstream out;
  out.precision(3);
  out << "rrt: " << (interrupted ? "interrupted" : "no path") << " after " << trees.size() << " nodes and "
      << trees.samples() << " samples; the trees from both ends came within "
      << std::min(trees.least_distance(), distance) << ", the ends are " << distance << " apart";
  if (!interrupted)
    out << ". The ends may lie on different parts of the domain; otherwise try a smaller step, more than max_nodes: "
        << options.max_nodes << ", or a larger reach";
  return out.str();
}

}  // namespace

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
  visit.field("seed", seed, {.help = "Seed of the samples; default: the seed of the run.", .minimum = 0});
}

RrtInitializer::RrtInitializer(const RrtOptions& options, int run_seed) : options_(options) {
  if (!options_.seed) options_.seed = run_seed;
  if (options.step && !(*options.step > 0)) throw OptionError("step", "must be greater than 0");
  if (options.shell && !(*options.shell >= 0)) throw OptionError("shell", "must be at least 0");
}

FirstPath RrtInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  if (problem.manifold->shape() == Shape::polyhedral)
    throw InitializationError("rrt works on smooth domains; a mesh has edges: use dijkstra");
  if (find_ability<HasChart>(*problem.manifold) != nullptr)
    throw InitializationError(
        "rrt works in the space around a domain; a chart has none: use straight, bow or waypoints");
  const double distance = (problem.target.u - problem.source.u).norm();
  RandomTrees trees(problem, options_);
  const std::optional<std::vector<Eigen::VectorXd>> nodes = trees.joined(monitor);
  if (!nodes) {
    if (trees.stopped()) throw Interrupted(failure(trees, options_, distance, true));
    throw InitializationError(failure(trees, options_, distance, false));
  }
  FirstPath first;
  first.notes.push_back("rrt: " + std::to_string(trees.size()) + " nodes, " + std::to_string(trees.samples()) +
                        " samples");
  first.path = as_open_path(trees.shortened(*nodes, monitor));
  pin_ends(problem, first.path);
  return first;
}

}  // namespace leastcost
