// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <leastcost/problems/bracket/cost_density.hpp>
#include <leastcost/problems/bracket/space_density.hpp>
#include "problems/bracket/cells/net.hpp"

namespace leastcost::bracket {

/// The net of a polynomial that is nowhere above the density in the part of the cell that lies in the box. -infinity
/// where nothing is known.
Net<2> density_floor(const CostDensity& density, const Grid<2>& grid, const Place<2>& cell);

/// A quadratic polynomial that is nowhere above a density in the part of a cube that lies in the box.
struct SpaceFloor {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double value = -kInfinity;  ///< at the centre; -infinity where nothing is known
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  std::array<double, 6> bend = {};  ///< kSymmetricEntries

  /// Its net on a cell of the cube, lowered by what rounding may have done.
  Net<3> on_cell(const Grid<3>& grid, const Place<3>& cell) const;
};

/// Of `part`, a cube's part in the box.
SpaceFloor space_floor(const SpaceDensity& density, const Eigen::AlignedBox3d& part);

/// What lies below a density in some cells of a grid.
template <int N>
class Floors;

template <>
class Floors<2> {
 public:
  void add_cell(const CostDensity& density, const Grid<2>& grid, const Place<2>& cell, bool) {
    floors_.push_back(density_floor(density, grid, cell));
  }
  /// Of the k-th of them.
  const Net<2>& on_cell(const Grid<2>&, const Place<2>&, std::size_t k) const { return floors_[k]; }

 private:
  std::vector<Net<2>> floors_;
};

template <>
class Floors<3> {
 public:
  /// `together`: with those before it of the same cube of 2^3 cells.
  void add_cell(const SpaceDensity& density, const Grid<3>& grid, const Place<3>& cell, bool together);
  Net<3> on_cell(const Grid<3>& grid, const Place<3>& cell, std::size_t k) const {
    return floors_[static_cast<std::size_t>(floor_of_[k])].on_cell(grid, cell);
  }

 private:
  std::vector<int> floor_of_;  ///< per cell: which of the floors is its own
  std::vector<SpaceFloor> floors_;
  Place<3> cube_ = {-1, -1, -1};  ///< of the last floor
};

}  // namespace leastcost::bracket
