// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include <leastcost/framework/numbers/dual.hpp>
#include "problems/bracket/space/cube_net.hpp"

namespace leastcost::bracket {

/// A spline around a place: the coefficients of its cell, and where in the cell the place is.
struct SplinePlace {
  bool known = false;  ///< whether all 27 coefficients are there
  CubeNet coefficients = {};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();

  SplinePlace(const SpaceGrid& grid, const NodeSet& nodes, const std::vector<double>& u, const Eigen::Vector3d& x) {
    const Place cell = grid.place_at(x);
    const int node = nodes.find(cell);
    known = node != nodes.none() && nodes.is_inner(node);
    if (!known) return;
    coefficients = around(nodes, u, node);
    at = (x - grid.node(cell)) / grid.h;
  }
};

/// Slope of the spline at a place; NaN where there is none.
inline Eigen::Vector3d spline_slope(const SpaceGrid& grid, const NodeSet& nodes, const std::vector<double>& u,
                                    const Eigen::Vector3d& x) {
  const SplinePlace place(grid, nodes, u, x);
  if (!place.known) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  using Slope = Dual<double, 3>;
  std::array<Slope, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = Slope(place.at[static_cast<int>(k)]);
    at[k].d[k] = 1;
  }
  const Slope value = spline_value<Slope>(place.coefficients, at);
  return Eigen::Vector3d(value.d[0], value.d[1], value.d[2]) / grid.h;
}

}  // namespace leastcost::bracket
