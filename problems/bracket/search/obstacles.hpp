// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// How deep a place lies in what no path enters: at most its distance from all places outside, positive inside; none:
/// there are no obstacles.
template <int N>
using Depth = std::function<double(const Vector<N>&)>;

/// What no path enters, as cells of a grid see it.
template <int N>
class Obstacles {
 public:
  explicit Obstacles(const Depth<N>& depth) : depth_(depth) {}

  bool any() const { return depth_ != nullptr; }
  const Depth<N>& depth() const { return depth_; }
  /// Whether a cell lies within the obstacles, so that nothing need be proved in it.
  bool hold(const Grid<N>& grid, const Place<N>& cell) const {
    return depth_ && depth_(grid.node(cell)) > grid.half_diagonal();
  }
  /// How deep a node lies in an obstacle, 0 outside.
  double depth_of(const Grid<N>& grid, const Place<N>& node) const {
    return depth_ ? std::max(0.0, depth_(grid.in_box(grid.node(node)))) : 0;
  }

 private:
  const Depth<N>& depth_;
};

}  // namespace leastcost::bracket
