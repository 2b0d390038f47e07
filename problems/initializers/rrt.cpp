// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/rrt.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include "problems/initializers/random_trees.hpp"

namespace leastcost {
namespace {

constexpr int kTimesIfFar = 3;  ///< as many paths of a robot where the best is far from straight

std::string failure(const RandomTrees& trees, const RrtOptions& options, double distance, bool interrupted) {
  std::ostringstream out;
  out.precision(3);
  out << "rrt: " << (interrupted ? "interrupted" : "no path") << " after " << trees.size() << " nodes and "
      << trees.samples() << " samples; the trees from both ends came within "
      << std::min(trees.least_distance(), distance) << ", but the ends are " << distance << " apart";
  if (!interrupted)
    out << ". The ends may be on different parts of the domain; otherwise try a smaller step, more than max_nodes: "
        << options.max_nodes << ", or a larger reach";
  return out.str();
}

/// Neither a string in space nor the chain of a robot leaves the class that it begins in, and a random path may be of a
/// dear one: with one path 4 of 70 problems of MotionBenchMaker ended more than 2 % above the best known. A robot's
/// moves take longer to check than a point's: fewer paths do for it.
int paths_by_default(const Problem& problem) {
  constexpr int kInSpace = 8, kOfRobot = 4;
  if (find_ability<ChecksMoves>(*problem.manifold) == nullptr || problem.source.u.size() < 3) return 1;
  return problem.source.u.size() == 3 ? kInSpace : kOfRobot;
}

/// What further paths may take of the time that is left: a quarter. The search for the least path needs the rest.
Monitor for_further_paths(const Monitor& monitor) {
  Monitor shorter = monitor;
  const auto now = Monitor::Clock::now();
  if (monitor.deadline) shorter.deadline = now + (*monitor.deadline - now) / 4;
  return shorter;
}

/// Looks for further paths, with trees of other seeds that may become a few times as large as those of the first: the
/// shortest of all that there is time for. Among `more` of them where the best is far from straight.
std::vector<Eigen::VectorXd> shortest_of(int paths, int more, std::vector<Eigen::VectorXd> best, int nodes_of_first,
                                         const Problem& problem, const RrtOptions& options, const Monitor& monitor) {
  constexpr int kTimesFirst = 4, kTimesFirstOfRobot = 1, kFewest = 200;  // moves of a robot take long to check
  constexpr std::uint64_t kNextSeed = 0x9E3779B97F4A7C15;                // far from the seeds that people take
  const int times = problem.source.u.size() > 3 ? kTimesFirstOfRobot : kTimesFirst;
  const int most = std::min(options.max_nodes, std::max(kFewest, times * nodes_of_first));
  constexpr double kFarFromStraight = 1.25;
  const double straight = (problem.target.u - problem.source.u).norm();
  const Monitor within = for_further_paths(monitor);
  auto seed = static_cast<std::uint64_t>(*options.seed);
  try {
    for (int k = 1; k < more && !within.interrupted(); ++k) {
      if (k >= paths && !(polyline_length(best) > kFarFromStraight * straight)) break;
      RandomTrees trees(problem, options, seed += kNextSeed);
      trees.look_for(polyline_length(best));
      const std::optional<std::vector<Eigen::VectorXd>> nodes = trees.joined(most, within);
      if (!nodes) continue;
      std::vector<Eigen::VectorXd> path = trees.shortened(*nodes, within, polyline_length(best));
      if (polyline_length(path) < polyline_length(best)) best = std::move(path);
    }
  } catch (const Interrupted&) {  // there is a path
  }
  return best;
}

}  // namespace

RrtInitializer::RrtInitializer(const RrtOptions& options, int run_seed) : options_(checked(options)) {
  if (!options_.seed) options_.seed = run_seed;
}

FirstPath RrtInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  if (problem.ring) throw InitializationError("a ring has no ends to join: give waypoints");
  if (problem.manifold->shape() == Shape::polyhedral)
    throw InitializationError("rrt works on smooth domains, but a mesh has edges: use dijkstra");
  if (find_ability<HasChart>(*problem.manifold) != nullptr)
    throw InitializationError(
        "rrt works in the space around a domain, but a chart has none: use straight, bow or waypoints");
  const double distance = (problem.target.u - problem.source.u).norm();
  if (!std::isfinite(distance * distance))
    throw InitializationError("rrt: the distance between the ends is too large: its square overflows");
  RandomTrees trees(problem, options_, static_cast<std::uint64_t>(*options_.seed));
  const std::optional<std::vector<Eigen::VectorXd>> nodes = trees.joined(options_.max_nodes, monitor);
  if (!nodes) {
    if (trees.stopped()) throw Interrupted(failure(trees, options_, distance, true));
    throw InitializationError(failure(trees, options_, distance, false));
  }
  FirstPath first;
  first.notes.push_back("rrt: " + std::to_string(trees.size()) + " nodes, " + std::to_string(trees.samples()) +
                        " samples");
  const int paths = options_.paths.value_or(paths_by_default(problem));
  const bool of_robot = !options_.paths && paths > 1 && problem.source.u.size() > 3;
  first.path = as_open_path(shortest_of(paths, of_robot ? kTimesIfFar * paths : paths, trees.shortened(*nodes, monitor),
                                        trees.size(), problem, options_, monitor));
  pin_ends(problem, first.path);
  return first;
}

}  // namespace leastcost
