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
/// shortest of all that there is time for. Of a robot's there are `more` if the best is far from straight, and no more
/// if it is nearly straight. They are compared when a few shortcuts have been tried, and only the best gets them all;
/// but not where the best is far from straight: in narrow passages few shortcuts say little.
class ShortestOf {
 public:
  ShortestOf(const Problem& problem, const RrtOptions& options, RandomTrees& first, const Monitor& monitor)
      : problem_(problem), options_(options), first_(first), monitor_(monitor), unfinished_(first.quick()) {}

  std::vector<Eigen::VectorXd> run(const std::vector<Eigen::VectorXd>& nodes_of_first, int paths, int more) {
    best_ = first_.roughly_shortened(nodes_of_first, monitor_);
    const Monitor within = for_further_paths(monitor_);
    auto seed = static_cast<std::uint64_t>(*options_.seed);
    try {
      for (int k = 1; k < more && !within.interrupted(); ++k) {
        if (k == paths || is_far_from_straight()) finish();
        if (more > paths && (k < paths ? is_nearly_straight() : !is_far_from_straight())) break;
        look_once_more(seed += kNextSeed, within);
      }
      finish();
    } catch (const Interrupted&) {  // there is a path
    }
    return std::move(best_);
  }

 private:
  static constexpr std::uint64_t kNextSeed = 0x9E3779B97F4A7C15;  ///< far from the seeds that people take

  double straight() const { return (problem_.target.u - problem_.source.u).norm(); }
  bool is_far_from_straight() const { return polyline_length(best_) > 1.25 * straight(); }
  bool is_nearly_straight() const { return polyline_length(best_) < 1.02 * straight(); }

  /// Moves of a robot take long to check.
  int most_nodes() const {
    constexpr int kTimesFirst = 4, kTimesFirstOfRobot = 1, kFewest = 200;
    const int times = problem_.source.u.size() > 3 ? kTimesFirstOfRobot : kTimesFirst;
    return std::min(options_.max_nodes, std::max(kFewest, times * first_.size()));
  }

  void look_once_more(std::uint64_t seed, const Monitor& within) {
    constexpr double kHopeless = 1.5;  // of the length of the best, when some shortcuts have been tried
    const bool far = is_far_from_straight();
    const double length = polyline_length(best_);
    RandomTrees trees(problem_, options_, seed);
    trees.look_for(length);
    const std::optional<std::vector<Eigen::VectorXd>> nodes = trees.joined(most_nodes(), within);
    if (!nodes) return;
    std::vector<Eigen::VectorXd> path =
        far ? trees.shortened(*nodes, within, kHopeless * length) : trees.roughly_shortened(*nodes, within, length);
    if (!(polyline_length(path) < length)) return;
    best_ = std::move(path);
    unfinished_ = !far && first_.quick();
  }

  void finish() {
    if (unfinished_) best_ = first_.shortened(best_, monitor_);
    unfinished_ = false;
  }

  const Problem& problem_;
  const RrtOptions& options_;
  RandomTrees& first_;
  const Monitor& monitor_;
  std::vector<Eigen::VectorXd> best_;
  bool unfinished_;  ///< what there are not all shortcuts of yet
};

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
  first.path = as_open_path(
      ShortestOf(problem, options_, trees, monitor).run(*nodes, paths, of_robot ? kTimesIfFar * paths : paths));
  pin_ends(problem, first.path);
  return first;
}

}  // namespace leastcost
