// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// A hierarchy over things in space, halved at the median along the longest side of their box: quick to build, of a
/// depth of log2 of their number. `Summary` holds what a search must know of all items below a node, such as a ball
/// around them. (ClosestPointTree is a tree of its own: it splits by surface area and searches upwards from a hint.)
template <class Item, class Summary>
class MedianTree {
 public:
  using Items = std::span<const Item>;

  /// `corners(item)` is a range of Vector3d whose sum orders the items; `summarise(Items)` makes a Summary. At most
  /// `leaf` items stay together.
  template <class Corners, class Summarise>
  MedianTree(std::vector<Item> items, std::ptrdiff_t leaf, const Corners& corners, const Summarise& summarise)
      : items_(std::move(items)) {
    if (!items_.empty()) build(0, std::ssize(items_), leaf, corners, summarise);
  }

  Items items() const { return items_; }  ///< what it was built of, in the order of its leaves

  /// Depth first: `enter(summary)` says whether to look below a node, `leaf(first, last)` gets what is there as places
  /// in items().
  template <class Enter, class Leaf>
  void visit(const Enter& enter, const Leaf& leaf) const {
    std::array<std::int32_t, kDeepest> open;
    std::size_t size = 0;
    if (!nodes_.empty()) open[size++] = 0;
    while (size > 0) {
      const std::int32_t at = open[--size];
      const Node& node = nodes_[static_cast<std::size_t>(at)];
      if (!enter(node.summary)) continue;
      if (node.second < 0) {
        leaf(node.first, node.last);
      } else {
        open[size++] = node.second;
        open[size++] = at + 1;
      }
    }
  }

  /// Nearest first: `bound(summary)` is a lower bound of the distance of all items below a node, and `offer(item)` gets
  /// each that may be nearer than `best()`.
  template <class Bound, class Offer, class Best>
  void visit_nearest(const Bound& bound, const Offer& offer, const Best& best) const {
    if (nodes_.empty()) return;
    std::array<std::pair<double, std::int32_t>, kDeepest> open;
    std::size_t size = 0;
    const auto with_bound = [&](std::int32_t at) {
      return std::pair(bound(nodes_[static_cast<std::size_t>(at)].summary), at);
    };
    open[size++] = with_bound(0);
    while (size > 0) {
      const auto [nearest, at] = open[--size];
      if (nearest > best()) continue;
      const Node& node = nodes_[static_cast<std::size_t>(at)];
      if (node.second < 0) {
        for (std::int32_t i = node.first; i < node.last; ++i) offer(items_[static_cast<std::size_t>(i)]);
        continue;
      }
      std::pair near = with_bound(at + 1), far = with_bound(node.second);
      if (far.first < near.first) std::swap(near, far);
      open[size++] = far;
      open[size++] = near;
    }
  }

 private:
  /// Nodes that wait in a search: one per level, and halving 32-bit numbers takes 32 levels.
  static constexpr std::size_t kDeepest = 64;

  struct Node {
    Summary summary;
    std::int32_t first = 0, last = 0;  ///< its items
    std::int32_t second = -1;          ///< second child (the first one follows its parent); -1: a leaf
  };

  template <class Corners, class Summarise>
  void build(std::ptrdiff_t first, std::ptrdiff_t last, std::ptrdiff_t leaf, const Corners& corners,
             const Summarise& summarise) {
    const std::size_t index = nodes_.size();
    nodes_.push_back(
        {summarise(items().subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first))),
         static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)});
    if (last - first <= leaf) return;
    const auto begin = items_.begin() + first, end = items_.begin() + last;
    Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (auto item = begin; item != end; ++item)
      for (const Eigen::Vector3d& p : corners(*item))
        low = low.min(p.array()).eval(), high = high.max(p.array()).eval();
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const auto along = [&](const Item& item) {
      double sum = 0;
      for (const Eigen::Vector3d& p : corners(item)) sum += p[axis];
      return sum;
    };
    const std::ptrdiff_t middle = first + (last - first) / 2;
    std::nth_element(begin, items_.begin() + middle, end,
                     [&](const Item& a, const Item& b) { return along(a) < along(b); });
    build(first, middle, leaf, corners, summarise);
    nodes_[index].second = static_cast<std::int32_t>(nodes_.size());
    build(middle, last, leaf, corners, summarise);
  }

  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

}  // namespace leastcost
