// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <leastcost/problems/distance/grid_shape.hpp>

namespace leastcost {

/// Whether the surface cannot lie between two neighbouring nodes: their distances from it add up to more than a cell.
inline bool same_side(double a, double b, double cell) { return a + b > (1 + 1e-9) * cell; }

/// Calls visit(index, node) for the nodes that share an edge of the grid with node `at` ({i, j, k}).
template <class Visit>
void for_neighbours(const GridShape& shape, const std::array<int, 3>& at, Visit visit) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int step : {-1, 1}) {
      std::array<int, 3> next = at;
      next[axis] += step;
      if (next[axis] < 0 || next[axis] >= shape.count[axis]) continue;
      visit(shape.index(next[0], next[1], next[2]), next);
    }
  }
}

/// Gives unsigned distances their signs. Nodes that hang together through pairs between which the surface cannot lie
/// are on one side of it, so that inside(x) is asked once for each such set, at its node farthest from the surface.
void sign_by_parts(const GridShape& shape, std::vector<double>& distances,
                   const std::function<bool(const Eigen::Vector3d& x, double distance)>& inside);

/// The same where the signs of some nodes are known (-1, 1; 0: unknown) and distances are right to a twentieth of a
/// cell: they spread. Returns a node that is reached from both sides, if there is one. Nodes that are reached from
/// nowhere become positive.
std::optional<Eigen::Vector3d> spread_signs(const GridShape& shape, std::vector<double>& distances,
                                            std::vector<std::int8_t> signs);

}  // namespace leastcost
