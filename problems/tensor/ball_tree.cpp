// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/tensor/ball_tree.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace leastcost {

BallTree::BallTree(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii)
    : order_(centres.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(centres.size());
  if (!centres.empty()) build(centres, radii, 0, static_cast<std::int32_t>(centres.size()));
}

/// Halves the places at the median along the longer side of their centres' box; returns the number of the node.
std::int32_t BallTree::build(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii,
                             std::int32_t first, std::int32_t last) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Node node{Eigen::Array3d::Constant(kInfinity), Eigen::Array3d::Constant(-kInfinity), first, last, 0};
  Eigen::Array3d low = node.low, high = node.high;
  for (std::int32_t place = first; place < last; ++place) {
    const auto i = static_cast<std::size_t>(order_[static_cast<std::size_t>(place)]);
    low = low.min(centres[i].array());
    high = high.max(centres[i].array());
    node.low = node.low.min(centres[i].array() - radii[i]);
    node.high = node.high.max(centres[i].array() + radii[i]);
  }
  const auto number = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back(node);
  if (last - first <= kLeafSize) return number;
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  const std::int32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](std::int32_t a, std::int32_t b) {
                     return centres[static_cast<std::size_t>(a)][axis] < centres[static_cast<std::size_t>(b)][axis];
                   });
  build(centres, radii, first, middle);
  const std::int32_t right = build(centres, radii, middle, last);
  nodes_[static_cast<std::size_t>(number)].right = right;
  return number;
}

}  // namespace leastcost
