// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/tensor/ball_tree.hpp>

#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace leastcost {

BallTree::BallTree(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii)
    : tree_(make_tree(centres, radii)) {}

BallTree::Tree BallTree::make_tree(const std::vector<Eigen::Vector3d>& centres, const std::vector<double>& radii) {
  constexpr std::ptrdiff_t kLeaf = 4;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<std::int32_t> numbers(centres.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto centre = [&](std::int32_t i) { return std::span(&centres[static_cast<std::size_t>(i)], 1); };
  const auto box = [&](Tree::Items balls) {
    Box all{Eigen::Array3d::Constant(kInfinity), Eigen::Array3d::Constant(-kInfinity)};
    for (const std::int32_t i : balls) {
      const auto k = static_cast<std::size_t>(i);
      all.low = all.low.min(centres[k].array() - radii[k]);
      all.high = all.high.max(centres[k].array() + radii[k]);
    }
    return all;
  };
  return Tree(std::move(numbers), kLeaf, centre, box);
}

}  // namespace leastcost
