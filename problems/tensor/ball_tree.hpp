// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include <leastcost/problems/mesh/median_tree.hpp>

namespace leastcost {

/// A ball around every point of a set: which of them hold x? A hierarchy of boxes, so that radii may change from point
/// to point as they like. Balls are named by their place in order(), in which neighbours are close in memory.
class BallTree {
 public:
  BallTree(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii);

  /// The number, in the lists given, of the ball at each place.
  std::span<const std::int32_t> order() const { return tree_.items(); }

  /// Calls visit(first, last) for runs of places [first, last); every ball that holds x is in one of them, with others
  /// beside it.
  template <class Visit>
  void near(const Eigen::Vector3d& x, const Visit& visit) const {
    const auto holds = [&](const Box& box) { return !((x.array() < box.low).any() || (x.array() > box.high).any()); };
    tree_.visit(holds, visit);
  }

 private:
  struct Box {  ///< of balls
    Eigen::Array3d low, high;
  };
  using Tree = MedianTree<std::int32_t, Box>;
  static Tree make_tree(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii);

  Tree tree_;
};

}  // namespace leastcost
