// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "problems/bracket/space/space_grid.hpp"

namespace leastcost::bracket {

/// Some nodes of a grid, those that potentials have values at: numbered along x, then y, then z, with their neighbours.
/// Values at the nodes are vectors of one number more, at `none()`, which stands for every node that is not among them.
class NodeSet {
 public:
  NodeSet() = default;
  /// `places` in the order of their numbers; `cells` of the grid.
  NodeSet(std::vector<Place> places, const Place& cells);

  std::size_t size() const { return places_.size(); }
  int none() const { return static_cast<int>(places_.size()); }
  const Place& place(int node) const { return places_[static_cast<std::size_t>(node)]; }
  const std::vector<Place>& places() const { return places_; }
  /// Number of a node, none() where it is not among them.
  int find(const Place& place) const;
  /// Neighbours: before and behind it along x, y, z.
  const std::array<int, 6>& beside(int node) const { return beside_[static_cast<std::size_t>(node)]; }
  /// Whether all 26 nodes around it are among them.
  bool is_inner(int node) const;
  /// The middles of the nine rows of the 27 nodes around an inner node, y running faster than z; the other nodes of a
  /// row have the numbers before and behind.
  std::array<int, 9> rows_around(int node) const;

 private:
  struct Range {
    int begin, end;
  };
  Range row(int j, int k) const;
  void link(const Range& low, const Range& high, std::size_t axis);

  int rows_y_ = 0, rows_z_ = 0;
  std::vector<Place> places_;
  std::vector<std::array<int, 6>> beside_;
  std::vector<int> begins_;  ///< first node of each row along x
};

}  // namespace leastcost::bracket
