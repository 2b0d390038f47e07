// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace leastcost::bracket {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEps = std::numeric_limits<double>::epsilon();

/// The larger of both; NaN, of which nothing is known, where one of them is.
inline double larger_or_nan(double a, double b) { return a >= b || a != a ? a : b; }

/// Square cells that tile a box and perhaps a little more, numbered from 1 to nx and ny; a row of cells lies around
/// them. A node is the centre of a cell. By definition cell i reaches from x0 + (i - 1) h to x0 + i h, without
/// rounding.
struct CellGrid {
  double x0 = 0, y0 = 0, h = 1;
  int nx = 0, ny = 0;
  Eigen::AlignedBox2d box;

  /// `cells` along the longer side of the box.
  static CellGrid over(const Eigen::AlignedBox2d& box, int cells) {
    const Eigen::Vector2d size = box.sizes();
    CellGrid g{box.min()[0], box.min()[1], size.maxCoeff() / cells, 0, 0, box};
    g.nx = static_cast<int>(std::ceil(size[0] / g.h * (1 - 1e-12)));
    g.ny = static_cast<int>(std::ceil(size[1] / g.h * (1 - 1e-12)));
    return g;
  }
  /// Every cell in `parts` x `parts`, a power of two, so that the sides are halved without rounding.
  CellGrid refined(int parts) const { return {x0, y0, h / parts, nx * parts, ny * parts, box}; }

  int stride() const { return nx + 2; }
  int nodes() const { return (nx + 2) * (ny + 2); }
  int id(int i, int j) const { return j * stride() + i; }
  int column(int node) const { return node % stride(); }
  int row(int node) const { return node / stride(); }
  bool is_cell(int i, int j) const { return i >= 1 && j >= 1 && i <= nx && j <= ny; }
  double x(int i) const { return x0 + (i - 0.5) * h; }
  double y(int j) const { return y0 + (j - 0.5) * h; }
  Eigen::Vector2d node(int i, int j) const { return {x(i), y(j)}; }
  int column_at(double px) const { return std::clamp(static_cast<int>(std::floor((px - x0) / h)) + 1, 1, nx); }
  int row_at(double py) const { return std::clamp(static_cast<int>(std::floor((py - y0) / h)) + 1, 1, ny); }
  Eigen::Vector2d in_box(const Eigen::Vector2d& p) const { return p.cwiseMax(box.min()).cwiseMin(box.max()); }

  /// What places of the grid are off by rounding, generously.
  double slack() const { return 1e-15 * (std::abs(x0) + std::abs(y0) + h * (nx + ny)); }
  /// Of a cell, rounded up, and what the places of its corners are off: a ball around its node holds the cell.
  double half_diagonal() const { return 0.70711 * h + 16 * slack(); }

  /// The part in the box of the square of (2 reach + 1)^2 cells around cell (i, j), rounded outward; empty where it
  /// lies outside.
  Eigen::AlignedBox2d cell(int i, int j, double reach = 0) const {
    const double half = (0.5 + reach) * h + slack();
    const Eigen::Vector2d c = node(i, j), r(half, half);
    return Eigen::AlignedBox2d(c - r, c + r).intersection(box);
  }
};

}  // namespace leastcost::bracket
