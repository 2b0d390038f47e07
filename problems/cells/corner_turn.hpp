// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "problems/cells/cell_map.hpp"
#include "problems/cells/gate_chain.hpp"

namespace leastcost {

/// The paths that go round a corner of cells instead of over it, on one side of it: by the sides that meet there.
struct CornerTurn {
  GateChain chain;           ///< from the place before the corner to that after it
  std::vector<int> outward;  ///< per gate: 1 where its coordinate grows away from the corner, -1 where it falls
};

/// The turn of a path a, corner, b, anticlockwise or clockwise; null where that passes an infinite cell. Both a and b
/// share a cell with the corner.
std::optional<CornerTurn> corner_turn(const CellMap& map, const Eigen::Vector2d& a, const Eigen::Vector2d& corner,
                                      const Eigen::Vector2d& b, bool anticlockwise);

/// How fast the cost falls when a path leaves the corner by this turn, per length along the first gate that is left; 0
/// or less: the corner is least among the paths nearby. To first order the cost changes by a homogeneous function of
/// the ways along the gates, neighbours of which are at right angles: the least of r on the next gate for 1 on this one
/// is min n sqrt(1 + r^2) + v r = sqrt(n^2 - v^2), v < 0 being what a unit of r changes from there on.
double steepest_fall(const CornerTurn& turn, const Eigen::Vector2d& corner);

}  // namespace leastcost
