// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/problems/bracket/coordinate_cost.hpp>
#include "problems/bracket/cells/blocked_parts.hpp"
#include "problems/bracket/cells/nodes.hpp"

namespace leastcost::bracket {

/// Looks at H(x, grad u) of a spline at the middles of the four quarters of each of some cells: nothing is proved in
/// between.
class SampledCells {
 public:
  SampledCells() = default;
  SampledCells(const CoordinateCost& cost, const Grid<2>& grid, const AllNodes& nodes, const std::vector<int>& cells);

  /// The largest at the places of the cell that is the k-th of them, but for those in blocked quarters; `sign` -1: of
  /// the moves back.
  double ratio(const Net<2>& coefficients, double h, std::size_t k, double sign, const BlockedParts& blocked) const;

 private:
  static constexpr int kPlaces = 4;
  const CoordinateCost* cost_ = nullptr;
  Points places_;  ///< of all cells, four times ambient x 3
};

}  // namespace leastcost::bracket
