// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <leastcost/problems/raster/raster.hpp>

namespace leastcost::test {

/// f(x, y) at the places of a raster of so many rows and columns, cells of (0.5, 0.25), lower left corner at (-1, 2).
template <class F>
RasterGrid raster_of(int rows, int columns, const F& f) {
  RasterGrid raster;
  raster.rows = rows;
  raster.columns = columns;
  raster.cell << 0.5, 0.25;
  raster.corner << -1, 2;
  raster.source = "made.asc";
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d at = raster.place(row, column);
      raster.values.push_back(f(at[0], at[1]));
    }
  return raster;
}

inline double waves(double x, double y) { return 2 + std::sin(x) * std::cos(1.5 * y) + 0.2 * x; }

/// No data at (row, column).
inline RasterGrid with_gap(RasterGrid raster, int row, int column) {
  raster.values[raster.index(row, column)] = std::numeric_limits<double>::quiet_NaN();
  return raster;
}

}  // namespace leastcost::test
