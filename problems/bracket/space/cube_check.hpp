// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <leastcost/problems/bracket/space/space_density.hpp>
#include "problems/bracket/space/cube_net.hpp"

namespace leastcost::bracket {

/// A quadratic polynomial that is nowhere above a density in the part of a cube that lies in the box.
struct SpaceFloor {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double value = -kInfinity;  ///< at the centre; -infinity where nothing is known
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  std::array<double, 6> bend = {};  ///< kSymmetricEntries

  /// Its net on a cell of the cube, lowered by what rounding may have done.
  CubeNet on_cell(const SpaceGrid& grid, const Place& cell) const;
};

/// Of `part`, a cube's part in the box.
SpaceFloor space_floor(const SpaceDensity& density, const Eigen::AlignedBox3d& part);

/// What proves |grad u| <= ratio n on a cell: control vectors of the gradient, all of which lie within `ratio` times
/// the net of a function below n. Mutations of the rules are what tests call with other numbers.
struct CubeRules {
  double rounding = 1;   ///< times what rounding may have done to a control vector
  unsigned dropped = 0;  ///< control vectors that are not looked at, a bit each: none
  int halvings = 0;      ///< of a cell whose control vectors are too long as they are
};

/// The least ratio that is proved for the spline with these coefficients on its cell of side h; infinite where nothing
/// is. `largest`: of the coefficients' sizes.
double proved_ratio(const CubeNet& coefficients, double h, double largest, const CubeNet& floor,
                    const CubeRules& rules = {});

}  // namespace leastcost::bracket
