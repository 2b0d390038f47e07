// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/distance/distance_grid.hpp>

namespace leastcost {

/// What a function on a grid does nowhere more than, but for rounding; 0 where it is nowhere that high.
struct GridBounds {
  double slope = 0;  ///< length of its gradient
  double bend = 0;   ///< its second derivative along a line, upwards, 1 / length
};

/// Bounds that hold in all cells where values may be above `from`. In a cell the spline is a polynomial: values,
/// gradients and second derivatives lie in the hulls of their Bezier control points, of which the longest gradient and
/// the most upwards bent are taken.
GridBounds bounds_above(const DistanceGrid& grid, double from);

/// The least value that it may have on the six sides of the grid, a lower bound.
double least_on_border(const DistanceGrid& grid);

}  // namespace leastcost
