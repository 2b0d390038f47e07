// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "ompl/plans/plan_trees.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace leastcost {
namespace {

using Vector = Eigen::VectorXd;

constexpr int kSamplesPerNode = 20;  ///< that may fail
constexpr double kSteps = 8;         ///< of the size of the space

struct Tree {
  std::vector<Vector> nodes;
  std::vector<int> parents;
  std::vector<Vector> branch(int node) const {
    std::vector<Vector> way;
    for (int i = node; i >= 0; i = parents[static_cast<std::size_t>(i)])
      way.push_back(nodes[static_cast<std::size_t>(i)]);
    return way;
  }
};

class Trees {
 public:
  Trees(const PlanSpace& space, const Vector& from, const Vector& to, std::uint64_t seed)
      : space_(space), engine_(seed) {
    trees_[0] = {{from}, {-1}};
    trees_[1] = {{to}, {-1}};
    constexpr int kPairs = 100;  // that say how large the space is
    for (int k = 0; k < kPairs; ++k) {
      const Vector one = space.random_place(engine_);
      step_ += (space.seen_from(one, space.random_place(engine_)) - one).norm() / kPairs / (kSteps / 2);
    }
  }

  std::optional<Points> joined(int most_nodes, const Monitor& monitor) {
    const auto size = [&] { return static_cast<int>(trees_[0].nodes.size() + trees_[1].nodes.size()); };
    for (long k = 0; k < static_cast<long>(kSamplesPerNode) * most_nodes && size() < most_nodes; ++k) {
      if (monitor.interrupted()) return {};
      const std::size_t growing = static_cast<std::size_t>(k % 2);
      const int gained = extend(trees_[growing], space_.random_place(engine_));
      if (gained < 0) continue;
      const Vector goal = trees_[growing].nodes[static_cast<std::size_t>(gained)];
      for (int met; (met = extend(trees_[1 - growing], goal)) >= 0;)
        if (reached_) return path(growing == 0 ? gained : met, growing == 0 ? met : gained);
    }
    return {};
  }

 private:
  /// One step from the nearest node; -1: it is blocked.
  int extend(Tree& tree, const Vector& goal) {
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const double far = (space_.seen_from(tree.nodes[i], goal) - tree.nodes[i]).squaredNorm();
      if (far < least) {
        least = far;
        nearest = static_cast<int>(i);
      }
    }
    const Vector from = tree.nodes[static_cast<std::size_t>(nearest)];
    Vector to = space_.seen_from(from, goal);
    const double far = std::sqrt(least);
    reached_ = far <= step_;
    if (!reached_) to = space_.between(from, to, step_ / far);
    if (!space_.clear_of_walls(from, to)) return -1;
    tree.nodes.push_back(to);
    tree.parents.push_back(nearest);
    return static_cast<int>(tree.nodes.size()) - 1;
  }

  Points path(int first, int second) const {
    std::vector<Vector> way = trees_[0].branch(first);
    std::reverse(way.begin(), way.end());
    const std::vector<Vector> rest = trees_[1].branch(second);
    way.insert(way.end(), rest.begin() + 1, rest.end());
    Points x(way.front().size(), static_cast<Index>(way.size()));
    x.col(0) = way.front();
    for (Index i = 1; i < x.cols(); ++i) x.col(i) = space_.seen_from(x.col(i - 1), way[static_cast<std::size_t>(i)]);
    return x;
  }

  const PlanSpace& space_;
  std::mt19937_64 engine_;
  std::array<Tree, 2> trees_;
  double step_ = 0;
  bool reached_ = false;
};

}  // namespace

std::optional<Points> random_plan(const PlanSpace& space, const Vector& from, const Vector& to, std::uint64_t seed,
                                  int most_nodes, const Monitor& monitor) {
  return Trees(space, from, to, seed).joined(most_nodes, monitor);
}

}  // namespace leastcost
