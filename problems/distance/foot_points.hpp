// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <leastcost/problems/distance/build_progress.hpp>
#include <leastcost/problems/distance/grid_shape.hpp>

namespace leastcost {

/// Unsigned distances at the nodes of a grid, with the points of the surface that they are measured to.
struct FootPointGrid {
  explicit FootPointGrid(const GridShape& grid);
  /// The foot of a node, to the seven digits that it is kept with.
  Eigen::Vector3d foot(std::size_t node) const { return shape.origin + feet[node].cast<double>(); }
  bool known(std::size_t node) const { return distance[node] < std::numeric_limits<double>::infinity(); }
  void set(std::size_t node, const Eigen::Vector3d& where, double how_far);

  GridShape shape;
  std::vector<double> distance;       ///< infinite where no foot is known
  std::vector<Eigen::Vector3f> feet;  ///< relative to the origin of the grid
  std::vector<std::int8_t> side;      ///< -1, 1; 0: not known
  std::vector<char> exact;            ///< 1: the foot is the nearest point, and is not replaced any more
};

/// The nearest point of a surface, with a number that helps to find that of a point beside it.
struct Foot {
  Eigen::Vector3d position;
  std::int32_t hint = -1;
  std::int8_t side = 0;  ///< of the surface on which the point lies that this is the foot of; 0: not known
};

/// Finds the feet of all nodes that hang together with the cells around the `seeds` (points of the surface) and are
/// nearer than `band` (length units), each by `nearest(x, hint)` with the hint of a neighbour. They become exact; nodes
/// without a foot stay unknown.
void fill_band(FootPointGrid& field, const std::vector<Eigen::Vector3d>& seeds, double band,
               const std::function<std::optional<Foot>(const Eigen::Vector3d& x, std::int32_t hint)>& nearest,
               const BuildProgress& progress);

/// Hands feet on from node to node (Danielsson's vector distance transform, all 26 neighbours): each node that is not
/// exact gets the nearest of the feet that arrive. Off by less than a hundredth of a cell beyond some cells from exact
/// nodes.
void spread_feet(FootPointGrid& field, const BuildProgress& progress);

}  // namespace leastcost
