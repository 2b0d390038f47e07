// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/rrt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/framework/checks_moves.hpp>
#include <leastcost/framework/clearance.hpp>
#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/has_sample_box.hpp>
#include "problems/initializers/growing_points.hpp"
#include "problems/section/projected_line.hpp"

namespace leastcost {
namespace {

using Vector = Eigen::VectorXd;

constexpr int kEdgePieces = 2;       ///< of an edge, before it is bisected
constexpr double kLongest = 1.5;     ///< a projected piece may be so much longer than the piece
constexpr int kSamplesPerNode = 20;  ///< samples that may fail for each node that is allowed

/// Uniform in [0, 1) from the engine's own bits: the same on every platform.
double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11U) * 0x1p-53; }

class Tree {
 public:
  Tree(const Problem& problem, const RrtOptions& options, double distance)
      : problem_(problem),
        options_(options),
        step_(options.step.value_or(distance / 16)),
        shell_(options.shell.value_or(step_ / 4)),
        engine_(static_cast<std::uint64_t>(options.seed.value_or(0))),
        lines_(*problem.manifold),
        points_(static_cast<int>(problem.source.u.size())) {
    const Vector margin = Vector::Constant(problem.source.u.size(), options.reach * distance);
    low_ = problem.source.u.cwiseMin(problem.target.u) - margin;
    high_ = problem.source.u.cwiseMax(problem.target.u) + margin;
    margin_ = margin;
    if (const auto* domain = find_ability<HasSampleBox>(*problem.manifold))
      of_use_ = domain->sample_box(problem.source.u, problem.target.u);
    add(problem.source.u, problem.source.u, -1);
  }

  int size() const { return points_.size(); }
  long samples() const { return samples_; }
  bool stopped() const { return stopped_; }  ///< by the monitor
  double nearest_to_goal() const { return nearest_to_goal_; }

  /// Grows until an edge ends at the target; false when the limits are reached or the monitor says stop.
  bool reach_target(const Monitor& monitor) {
    const long most = static_cast<long>(kSamplesPerNode) * options_.max_nodes;
    constexpr long kAskEvery = 4;
    for (; size() < options_.max_nodes && samples_ < most; ++samples_) {
      if (samples_ % kAskEvery == 0 && monitor.interrupted()) {
        stopped_ = true;
        return false;
      }
      const int added = grow_towards(sample());
      if (added < 0 || (feet_[index(added)] - problem_.target.u).norm() > step_) continue;
      if (!joins(added, problem_.target.u)) continue;
      add(problem_.target.u, problem_.target.u, added);
      return true;
    }
    return false;
  }

  /// The nodes from the source to the one added last, on the domain.
  std::vector<Vector> branch() const {
    std::vector<Vector> nodes;
    for (int i = size() - 1; i >= 0; i = parents_[index(i)]) nodes.push_back(feet_[index(i)]);
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  /// Leaves out what lies between two nodes whose straight line projects to something shorter; then the whole path on
  /// the domain.
  std::vector<Vector> shortened(std::vector<Vector> nodes, const Monitor& monitor) {
    std::vector<std::vector<Vector>> pieces;  // piece i: from node i to node i + 1, without its first point
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      pieces.emplace_back();
      look_at_clock(monitor.deadline);
      line(nodes[i], nodes[i + 1], pieces.back());
    }
    for (int k = 0; k < options_.shortcuts && nodes.size() > 2 && !monitor.interrupted(); ++k) {
      const auto pick = [&] { return static_cast<std::size_t>(uniform(engine_) * static_cast<double>(nodes.size())); };
      const auto [i, j] = std::minmax({pick(), pick()});
      if (j < i + 2) continue;
      std::vector<Vector> shortcut;
      if (!line(nodes[i], nodes[j], shortcut)) continue;
      if (!(length(nodes[i], {shortcut}) <
            length(nodes[i], {pieces.begin() + signed_of(i), pieces.begin() + signed_of(j)})))
        continue;
      pieces.erase(pieces.begin() + signed_of(i) + 1, pieces.begin() + signed_of(j));
      pieces[i] = std::move(shortcut);
      nodes.erase(nodes.begin() + signed_of(i) + 1, nodes.begin() + signed_of(j));
    }
    std::vector<Vector> path = {nodes.front()};
    for (const std::vector<Vector>& piece : pieces) path.insert(path.end(), piece.begin(), piece.end());
    return path;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static std::ptrdiff_t signed_of(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  static double length(const Vector& start, const std::vector<std::vector<Vector>>& pieces) {
    std::vector<Vector> points = {start};
    for (const std::vector<Vector>& piece : pieces) points.insert(points.end(), piece.begin(), piece.end());
    return polyline_length(points);
  }

  int add(const Vector& x, const Vector& foot, int parent) {
    low_ = low_.cwiseMin(x - margin_);
    high_ = high_.cwiseMax(x + margin_);
    feet_.push_back(foot);
    parents_.push_back(parent);
    nearest_to_goal_ = std::min(nearest_to_goal_, (foot - problem_.target.u).norm());
    return points_.add(x);
  }

  Vector sample() {
    if (uniform(engine_) < options_.goal_bias) return problem_.target.u;
    const bool known = of_use_.lower.size() > 0;
    const Vector low = known ? Vector(low_.cwiseMax(of_use_.lower)) : low_;
    const Vector high = known ? Vector(high_.cwiseMin(of_use_.upper)) : high_;
    return low + Vector::NullaryExpr(low.size(), [&] { return uniform(engine_); }).cwiseProduct(high - low);
  }

  /// One step from the nearest node towards x, then into the shell; the new node, or -1.
  int grow_towards(const Vector& x) {
    const int from = points_.nearest(x);
    const Vector start = points_[from], way = x - start;
    const double distance = way.norm();
    if (!(distance > 0)) return -1;
    Vector moved = start + std::min(1.0, step_ / distance) * way;
    const std::optional<Vector> foot = lines_.nearest(moved);
    if (!foot) return -1;
    const double off = (moved - *foot).norm();
    if (off > shell_) moved = *foot + shell_ / off * (moved - *foot);
    // A node that brings nothing new (the domain ends here, or the step went straight off it) would only be in the way.
    constexpr double kProgress = 0.1;
    if ((*foot - feet_[index(from)]).norm() < kProgress * std::min(step_, distance)) return -1;
    return joins(from, *foot) ? add(moved, *foot, from) : -1;
  }

  /// Whether an edge may lead from the foot of a node to another.
  bool joins(int from, const Vector& foot) {
    const Vector& start = feet_[index(from)];
    if ((foot - start).norm() > 2 * kLongest * step_) return false;
    edge_.clear();
    return line(start, foot, edge_);
  }

  /// The projection of a -> b in pieces of about half a step into `out`, which is empty; false where there is no
  /// continuous one or its cost is infinite.
  bool line(const Vector& a, const Vector& b, std::vector<Vector>& out) {
    const double distance = (b - a).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(kEdgePieces * distance / step_)));
    if (!lines_.append(a, b, pieces, kLongest * step_ / kEdgePieces, out)) return false;
    const Vector* from = &a;
    for (const Vector& to : out) {
      if (!std::isfinite(move_cost(*problem_.cost, *from, to))) return false;
      if (obstacles_ != nullptr && !goes_clear(*obstacles_, *from, to)) return false;
      from = &to;
    }
    return true;
  }

  const Problem& problem_;
  const ChecksMoves* obstacles_ = find_ability<ChecksMoves>(*problem_.manifold);
  const RrtOptions& options_;
  double step_, shell_;
  std::mt19937_64 engine_;
  LineProjector lines_;
  GrowingPoints points_;      ///< in the shell
  std::vector<Vector> feet_;  ///< on the domain
  std::vector<int> parents_;
  std::vector<Vector> edge_;
  Vector low_, high_, margin_;  ///< the box of samples: the tree, with a margin
  SampleBox of_use_;            ///< none but within these are; empty: not known
  long samples_ = 0;
  bool stopped_ = false;
  double nearest_to_goal_ = std::numeric_limits<double>::infinity();
};

std::string failure(const Tree& tree, const RrtOptions& options, double distance, bool interrupted) {
  std::ostringstream out;
  out.precision(3);
  out << "rrt: " << (interrupted ? "interrupted" : "no path") << " after " << tree.size() << " nodes and "
      << tree.samples() << " samples; the nearest node is " << tree.nearest_to_goal()
      << " from the target, the ends are " << distance << " apart";
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
  visit.field("goal_bias", goal_bias, {.help = "Share of samples that are the target.", .minimum = 0, .maximum = 1});
  visit.field("reach", reach,
              {.help = "How far beyond the tree samples are taken, in distances of the ends.",
               .minimum = 0,
               .exclusive_minimum = true});
  visit.field("max_nodes", max_nodes, {.help = "Nodes after which the search gives up.", .minimum = 1});
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
  Tree tree(problem, options_, distance);
  if (!tree.reach_target(monitor)) {
    if (tree.stopped()) throw Interrupted(failure(tree, options_, distance, true));
    throw InitializationError(failure(tree, options_, distance, false));
  }
  FirstPath first;
  first.notes.push_back("rrt: " + std::to_string(tree.size()) + " nodes, " + std::to_string(tree.samples()) +
                        " samples");
  first.path = as_open_path(tree.shortened(tree.branch(), monitor));
  pin_ends(problem, first.path);
  return first;
}

}  // namespace leastcost
