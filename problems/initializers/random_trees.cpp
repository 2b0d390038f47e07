// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/initializers/random_trees.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leastcost {
namespace {

using Vector = Eigen::VectorXd;

constexpr double kLongest = 3;             ///< an edge may be so many steps long
constexpr int kSamplesPerNode = 20;        ///< samples that may fail for each node that is allowed
constexpr double kShortestStep = 1.0 / 8;  ///< of a step that is taken where a whole one is blocked
constexpr double kProgress = 0.1;          ///< of a step: a node that brings less would only be in the way

/// A sixteenth of the distance of the ends. Where moves are told quickly long ones cost little: a sixteenth of the
/// diagonal of the domain, which for the joints of an arm is 1 to 2 rad.
double step_by_default(const Problem& problem) {
  constexpr double kSteps = 16;
  const auto* box = find_ability<HasBox>(*problem.manifold);
  if (find_ability<DecidesMoves>(*problem.manifold) != nullptr && box != nullptr) {
    const double diagonal = (box->box_upper() - box->box_lower()).norm();
    if (diagonal > 0 && std::isfinite(diagonal)) return diagonal / kSteps;
  }
  return (problem.target.u - problem.source.u).norm() / kSteps;
}

}  // namespace

RandomTree::RandomTree(const Vector& root) : points_(static_cast<int>(root.size())) { add(root, root, -1); }

int RandomTree::add(const Vector& x, const Vector& foot, int parent) {
  feet_.push_back(foot);
  parents_.push_back(parent);
  return points_.add(x);
}

std::vector<Vector> RandomTree::branch(int node) const {
  std::vector<Vector> nodes;
  for (int i = node; i >= 0; i = parents_[static_cast<std::size_t>(i)]) nodes.push_back(foot(i));
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

RandomTrees::RandomTrees(const Problem& problem, const RrtOptions& options, std::uint64_t seed)
    : options_(options),
      step_(options.step.value_or(step_by_default(problem))),
      shell_(options.shell.value_or(step_ / 4)),
      engine_(seed),
      lines_(problem, step_),
      trees_{RandomTree(problem.source.u), RandomTree(problem.target.u)},
      margin_(Vector::Constant(problem.source.u.size(), options.reach * (problem.target.u - problem.source.u).norm())) {
  around_ends_ = {problem.source.u.cwiseMin(problem.target.u) - margin_,
                  problem.source.u.cwiseMax(problem.target.u) + margin_};
  around_trees_ = around_ends_;
  if (const auto* domain = find_ability<HasSampleBox>(*problem.manifold))
    of_use_ = domain->sample_box(problem.source.u, problem.target.u);
  else if (const auto* box = lines_.quick() ? find_ability<HasBox>(*problem.manifold) : nullptr)
    of_use_ = {box->box_lower(), box->box_upper()};
}

/// The box of the ellipsoid whose foci are the ends (Gammell, Srinivasa and Barfoot 2014, informed RRT*).
void RandomTrees::look_for(double length) {
  const Vector& source = trees_[0].foot(0);
  const Vector& target = trees_[1].foot(0);
  const double apart = (target - source).norm();
  if (!(apart > 0)) return;
  const double along = length / 2, across = std::sqrt(std::max(0.0, length * length - apart * apart)) / 2;
  const Eigen::ArrayXd axis = ((target - source) / apart).array().square();
  const Vector half = (along * along * axis + across * across * (1 - axis)).sqrt(), middle = (source + target) / 2;
  if (of_use_.lower.size() == 0) of_use_ = {middle - half, middle + half};
  of_use_.lower = of_use_.lower.cwiseMax(middle - half);
  of_use_.upper = of_use_.upper.cwiseMin(middle + half);
}

std::optional<std::vector<Vector>> RandomTrees::joined(int most_nodes, const Monitor& monitor) {
  most_nodes_ = most_nodes;
  const Vector &source = trees_[0].foot(0), &target = trees_[1].foot(0);
  if (lines_.quick() && lines_.is_clear(source, target)) return std::vector<Vector>{source, target};
  const long most = static_cast<long>(kSamplesPerNode) * most_nodes;
  for (int tree = 0; samples_ < most; tree = 1 - tree, ++samples_) {
    if (is_over(monitor)) return {};
    const Vector x = sample(trees_[static_cast<std::size_t>(1 - tree)].foot(0));
    RandomTree& growing = trees_[static_cast<std::size_t>(tree)];
    const int gained = extend(tree, growing.nearest(x), x);
    if (gained < 0) continue;
    const int met = connect(1 - tree, growing.foot(gained), monitor);
    if (met < 0) continue;
    std::vector<Vector> nodes = trees_[0].branch(tree == 0 ? gained : met);
    const std::vector<Vector> rest = trees_[1].branch(tree == 0 ? met : gained);
    nodes.insert(nodes.end(), rest.rbegin(), rest.rend());
    return nodes;
  }
  return {};
}

std::vector<Vector> RandomTrees::shortened(const std::vector<Vector>& nodes, const Monitor& monitor, double longest) {
  return lines_.shortened(nodes, options_.shortcuts, longest, engine_, monitor);
}

std::vector<Vector> RandomTrees::roughly_shortened(const std::vector<Vector>& nodes, const Monitor& monitor,
                                                   double longest) {
  return lines_.roughly_shortened(nodes, options_.shortcuts, longest, engine_, monitor);
}

/// Whether the limit of nodes is reached or the monitor says stop.
bool RandomTrees::is_over(const Monitor& monitor) {
  if (size() >= most_nodes_) return true;
  constexpr long kAskEvery = 4;
  stopped_ = stopped_ || (samples_ % kAskEvery == 0 && monitor.interrupted());
  return stopped_;
}

/// The other end, or uniform in one of two boxes: around the ends, where most paths are, or around all that the trees
/// have reached, which may have to go far.
Vector RandomTrees::sample(const Vector& other_end) {
  const double chance = uniform_number(engine_);
  if (chance < options_.goal_bias) return other_end;
  const SampleBox& box = chance < (1 + options_.goal_bias) / 2 ? around_ends_ : around_trees_;
  const bool known = of_use_.lower.size() > 0;
  const Vector low = known ? Vector(box.lower.cwiseMax(of_use_.lower)) : box.lower;
  const Vector high = known ? Vector(box.upper.cwiseMin(of_use_.upper)) : box.upper;
  return low + Vector::NullaryExpr(low.size(), [&] { return uniform_number(engine_); }).cwiseProduct(high - low);
}

/// Where samples cost little long steps alone are tried, until there have been so many that the way must be narrow.
double RandomTrees::shortest_quick_step() const {
  constexpr double kAtFirst = 1.0 / 2, kAtLast = 1.0 / 64;
  constexpr double kSamplesPerHalving = 1000;
  return std::max(kAtLast, kAtFirst * std::exp2(-std::floor(static_cast<double>(samples_) / kSamplesPerHalving)));
}

/// One step from a node towards x, then into the shell; less than a step where that is blocked. The new node, or -1.
int RandomTrees::extend(int tree, int from, const Vector& x) {
  RandomTree& growing = trees_[static_cast<std::size_t>(tree)];
  const Vector start = growing.node(from), way = x - start;
  const double distance = way.norm(), whole = std::min(step_, distance);
  if (!(distance > 0)) return -1;
  const double shortest = lines_.quick() ? shortest_quick_step() : kShortestStep;
  for (double length = whole; length >= shortest * whole; length /= 2) {
    Vector moved = start + length / distance * way;
    const std::optional<Vector> foot = lines_.nearest(moved);
    if (!foot) continue;
    const double off = (moved - *foot).norm();
    if (off > shell_) moved = *foot + shell_ / off * (moved - *foot);
    if ((*foot - growing.foot(from)).norm() < std::min(kProgress, shortest / 2) * whole) return -1;
    if (!joins(tree, from, *foot)) continue;
    around_trees_.lower = around_trees_.lower.cwiseMin(moved - margin_);
    around_trees_.upper = around_trees_.upper.cwiseMax(moved + margin_);
    return growing.add(moved, *foot, from);
  }
  return -1;
}

/// Grows a tree towards a point of the domain as far as it gets; the node whose edge to it is free, or -1.
int RandomTrees::connect(int tree, const Vector& goal, const Monitor& monitor) {
  const RandomTree& growing = trees_[static_cast<std::size_t>(tree)];
  int node = growing.nearest(goal);
  double left = (growing.foot(node) - goal).norm();
  distance_ = std::min(distance_, left);
  while (!(left <= step_ && joins(tree, node, goal))) {
    if (is_over(monitor)) return -1;
    node = extend(tree, node, goal);
    if (node < 0) return -1;
    const double now = (growing.foot(node) - goal).norm();
    if (!(now < left)) return -1;
    distance_ = std::min(distance_, left = now);
  }
  return node;
}

/// Whether an edge may lead from the foot of a node to another point, in the sense in which the path will run.
bool RandomTrees::joins(int tree, int from, const Vector& foot) {
  const Vector& start = trees_[static_cast<std::size_t>(tree)].foot(from);
  if ((foot - start).norm() > kLongest * step_) return false;
  return tree == 0 ? lines_.is_clear(start, foot) : lines_.is_clear(foot, start);
}

}  // namespace leastcost
