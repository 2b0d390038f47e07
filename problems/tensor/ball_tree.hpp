// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// A ball around every point of a set: which of them hold x? A hierarchy of boxes, so that radii may change from point
/// to point as they like. Balls are named by their place in order(), in which neighbours are close in memory.
class BallTree {
 public:
  BallTree(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii);

  /// The number, in the lists given, of the ball at each place.
  const std::vector<std::int32_t>& order() const { return order_; }

  /// Calls visit(first, last) for runs of places [first, last); every ball that holds x is in one of them, with others
  /// beside it.
  template <class Visit>
  void near(const Eigen::Vector3d& x, Visit visit) const {
    std::array<std::int32_t, kDeepest> stack;
    std::size_t depth = 0;
    if (!nodes_.empty()) stack[depth++] = 0;
    while (depth > 0) {
      const std::int32_t i = stack[--depth];
      const Node& node = nodes_[static_cast<std::size_t>(i)];
      if ((x.array() < node.low).any() || (x.array() > node.high).any()) continue;
      if (node.right == 0) {
        visit(node.first, node.last);
      } else {
        stack[depth++] = node.right;
        stack[depth++] = i + 1;
      }
    }
  }

 private:
  static constexpr std::size_t kDeepest = 64;  ///< halving: more than 32-bit numbers need
  static constexpr std::int32_t kLeafSize = 4;

  struct Node {
    Eigen::Array3d low, high;          ///< of its balls
    std::int32_t first = 0, last = 0;  ///< its places
    std::int32_t right = 0;            ///< second child (the first one follows its parent); 0: a leaf
  };

  std::int32_t build(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii, std::int32_t first,
                     std::int32_t last);

  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace leastcost
