// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace leastcost::app {

/// Values on the nodes of a rectangular grid, columns first, from below. +infinity: there is no value.
struct Grid {
  int columns = 0, rows = 0;
  std::vector<double> values;
  double at(int i, int j) const {
    return values[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)];
  }
};

/// From a place in units of cells to one of the drawing, along one axis.
using ToDrawing = std::function<double(double)>;

/// The region where the bilinear function between the nodes is at least `level`, as SVG path data: marching squares,
/// cells that lie inside as a whole merged row by row. Infinite values are above every level.
std::string region_above(const Grid& grid, double level, const ToDrawing& x, const ToDrawing& y);

/// The line where the bilinear function between the nodes is `level`, as SVG path data. Not in cells with a node
/// without value.
std::string line_at(const Grid& grid, double level, const ToDrawing& x, const ToDrawing& y);

/// The cells with a node without value.
std::string region_infinite(const Grid& grid, const ToDrawing& x, const ToDrawing& y);

}  // namespace leastcost::app
