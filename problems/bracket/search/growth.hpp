// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {

/// By which the density grows so deep in what no path enters, so that potentials go on smoothly a little way. Where it
/// is flat paths dip, by a part of its square; where it is steep u is too steep outside, as its inverse square is. In
/// the plane both are least for a length in the middle between a cell and what obstacles are bent by; in space, on
/// coarser grids, it is flat where searched cells reach into an obstacle.
inline double growth_at_depth(const Grid<2>& grid, double depth) {
  constexpr double kPart = 0.125, kLeast = 4;  // of the grid; cells
  const double cells = std::max(kLeast, std::sqrt(kPart * grid.longest()));
  const double deep = depth / (cells * grid.h);
  return 1 + deep * deep;
}
inline double growth_at_depth(const Grid<3>& grid, double depth) {
  constexpr double kCells = 6;
  const double deep = depth / (kCells * grid.h);
  return 1 + deep * deep * deep * deep;
}

}  // namespace leastcost::bracket
