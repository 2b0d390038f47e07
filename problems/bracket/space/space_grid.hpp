// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "problems/bracket/cell_grid.hpp"

namespace leastcost::bracket {

/// Number of a cell of a SpaceGrid along each axis.
using Place = std::array<int, 3>;

/// Cubic cells that tile a box and perhaps a little more, numbered from 1 to cells[k] along axis k; a layer of cells
/// lies around them. A node is the centre of a cell. By definition cell i reaches from corner + (i - 1) h to corner +
/// i h, without rounding.
struct SpaceGrid {
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  double h = 1;
  Place cells = {0, 0, 0};
  Eigen::AlignedBox3d box;

  /// `count` cells along the longest side of the box.
  static SpaceGrid over(const Eigen::AlignedBox3d& box, int count) {
    constexpr double kWhole = 1 + 1e-13;  // so that the cells cover a box of whole numbers of them, rounding included
    const Eigen::Vector3d size = box.sizes();
    SpaceGrid g{box.min(), size.maxCoeff() / count * kWhole, {0, 0, 0}, box};
    for (std::size_t k = 0; k < 3; ++k)
      g.cells[k] = static_cast<int>(std::ceil(size[static_cast<int>(k)] / g.h * (1 + 1e-15)));
    return g;
  }
  /// Every cell in `parts`^3, a power of two, so that the sides are halved without rounding.
  SpaceGrid refined(int parts) const {
    return {corner, h / parts, {cells[0] * parts, cells[1] * parts, cells[2] * parts}, box};
  }

  int longest() const { return *std::max_element(cells.begin(), cells.end()); }
  double coordinate(int axis, int i) const { return corner[axis] + (i - 0.5) * h; }
  Eigen::Vector3d node(const Place& p) const { return {coordinate(0, p[0]), coordinate(1, p[1]), coordinate(2, p[2])}; }
  bool is_cell(const Place& p) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (p[k] < 1 || p[k] > cells[k]) return false;
    return true;
  }
  Place place_at(const Eigen::Vector3d& x) const {
    Place p;
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(k);
      p[a] = std::clamp(static_cast<int>(std::floor((x[k] - corner[k]) / h)) + 1, 1, cells[a]);
    }
    return p;
  }
  Eigen::Vector3d in_box(const Eigen::Vector3d& p) const { return p.cwiseMax(box.min()).cwiseMin(box.max()); }

  /// More than the coordinates of a place lose by rounding.
  double slack() const { return 1e-15 * (corner.cwiseAbs().sum() + h * (cells[0] + cells[1] + cells[2])); }
  /// The part in the box of the cube of side 2 `half` cells around a place in units of cells, rounded outward; empty
  /// where it lies outside.
  Eigen::AlignedBox3d cube(const Eigen::Vector3d& middle, double half) const {
    const Eigen::Vector3d c = corner + (middle.array() - 0.5).matrix() * h;
    const Eigen::Vector3d r = Eigen::Vector3d::Constant(half * h + slack());
    return Eigen::AlignedBox3d(c - r, c + r).intersection(box);
  }
  Eigen::AlignedBox3d cell(const Place& p, double reach = 0) const {
    return cube(Eigen::Vector3d(p[0], p[1], p[2]), 0.5 + reach);
  }
};

}  // namespace leastcost::bracket
