// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "problems/bracket/cells/net.hpp"

namespace leastcost::bracket {

/// All nodes of a grid in the plane, numbered row by row: those that potentials have values at. Values at the nodes are
/// vectors of one number more, at `none()`, which stands for every node that is not among them.
class AllNodes {
 public:
  static constexpr int kDimension = 2;
  AllNodes() = default;
  explicit AllNodes(const Place<2>& cells) : stride_(cells[0] + 2), rows_(cells[1] + 2) {}

  std::size_t size() const { return static_cast<std::size_t>(none()); }
  int none() const { return stride_ * rows_; }
  Place<2> place(int node) const { return {node % stride_, node / stride_}; }
  bool holds(const Place<2>& p) const { return p[0] >= 0 && p[1] >= 0 && p[0] < stride_ && p[1] < rows_; }
  /// Number of a node, none() where it is not among them.
  int find(const Place<2>& p) const { return holds(p) ? p[1] * stride_ + p[0] : none(); }
  /// Neighbours: before and behind it along x, y.
  std::array<int, 4> beside(int node) const {
    const int i = node % stride_;
    return {i > 0 ? node - 1 : none(), i + 1 < stride_ ? node + 1 : none(), node >= stride_ ? node - stride_ : none(),
            node + stride_ < none() ? node + stride_ : none()};
  }
  /// Whether all 8 nodes around it are among them.
  bool is_inner(int node) const {
    const Place<2> p = place(node);
    return p[0] > 0 && p[1] > 0 && p[0] + 1 < stride_ && p[1] + 1 < rows_;
  }
  /// The middles of the three rows of the 9 nodes around an inner node; the other nodes of a row have the numbers
  /// before and behind.
  std::array<int, 3> rows_around(int node) const { return {node - stride_, node, node + stride_}; }
  /// Calls f with the nodes that have all neighbours, and those.
  template <class F>
  void for_each_with_neighbours(const F& f) const {
    for (int row = 1; row + 1 < rows_; ++row)
      for (int node = row * stride_ + 1; node + 1 < (row + 1) * stride_; ++node)
        f(node, std::array<int, 4>{node - 1, node + 1, node - stride_, node + stride_});
  }

 private:
  int stride_ = 0, rows_ = 0;
};

/// Some nodes of a grid in space, as AllNodes has them in the plane: numbered along x, then y, then z, with their
/// neighbours.
class NodeSet {
 public:
  static constexpr int kDimension = 3;
  NodeSet() = default;
  /// All nodes of the grid.
  explicit NodeSet(const Place<3>& cells);
  /// `places` in the order of their numbers; `cells` of the grid.
  NodeSet(std::vector<Place<3>> places, const Place<3>& cells);

  std::size_t size() const { return places_.size(); }
  int none() const { return static_cast<int>(places_.size()); }
  const Place<3>& place(int node) const { return places_[static_cast<std::size_t>(node)]; }
  const std::vector<Place<3>>& places() const { return places_; }
  /// Number of a node, none() where it is not among them.
  int find(const Place<3>& place) const;
  /// Neighbours: before and behind it along x, y, z.
  const std::array<int, 6>& beside(int node) const { return beside_[static_cast<std::size_t>(node)]; }
  /// Whether all 26 nodes around it are among them.
  bool is_inner(int node) const;
  /// The middles of the nine rows of the 27 nodes around an inner node, y running faster than z; the other nodes of a
  /// row have the numbers before and behind.
  std::array<int, 9> rows_around(int node) const;
  /// Calls f with the nodes and their neighbours, be they there or not.
  template <class F>
  void for_each_with_neighbours(const F& f) const {
    for (int node = 0; node < none(); ++node) f(node, beside(node));
  }

 private:
  struct Range {
    int begin, end;
  };
  Range row(int j, int k) const;
  void link(const Range& low, const Range& high, std::size_t axis);

  int rows_y_ = 0, rows_z_ = 0;
  std::vector<Place<3>> places_;
  std::vector<std::array<int, 6>> beside_;
  std::vector<int> begins_;  ///< first node of each row along x
};

/// Those of a grid that a search keeps: in the plane a vector for all costs less than to look for neighbours.
template <int N>
using Nodes = std::conditional_t<N == 2, AllNodes, NodeSet>;

/// The nodes of a fine grid that a search of some of its cells needs: in space all in coarse cells around those that
/// hold one of `cells`, for at the rim of its nodes a march is wrong, and that spreads with the number of cells it
/// goes.
inline AllNodes nodes_around(const Grid<2>&, const Grid<2>& fine, const std::vector<Place<2>>&, int) {
  return AllNodes(fine.cells);
}
NodeSet nodes_around(const Grid<3>& coarse, const Grid<3>& fine, const std::vector<Place<3>>& cells, int parts);

/// The numbers of `u` at and around an inner node.
template <class SomeNodes>
Net<SomeNodes::kDimension> around(const SomeNodes& nodes, const std::vector<double>& u, int node) {
  Net<SomeNodes::kDimension> out;
  std::size_t k = 0;
  for (const int row : nodes.rows_around(node))
    for (int p = -1; p <= 1; ++p) out[k++] = u[static_cast<std::size_t>(row + p)];
  return out;
}

}  // namespace leastcost::bracket
