// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "problems/cells/cell_map.hpp"

namespace leastcost {

/// The corners of cells and, on each side, `points` places that part it equally, with numbers.
class SideNodes {
 public:
  SideNodes(const CellMap& map, int points)
      : map_(map),
        points_(points),
        columns_(map.columns()),
        rows_(map.rows()),
        vertical_((columns_ + 1) * (rows_ + 1)),
        horizontal_(vertical_ + (columns_ + 1) * rows_ * points) {}

  int count() const { return horizontal_ + columns_ * (rows_ + 1) * points_; }
  static double count_for(const CellMap& map, int points) {
    return (map.columns() + 1.0) * (map.rows() + 1.0) * (1 + 2.0 * points);
  }
  int around() const { return 4 * (points_ + 1); }  ///< a cell

  /// The nodes around a cell, anticlockwise from its lower left corner.
  void around(int row, int column, std::vector<int>& nodes) const {
    nodes.clear();
    nodes.push_back(corner(row, column));
    for (int j = 0; j < points_; ++j) nodes.push_back(on_horizontal(row, column, j));
    nodes.push_back(corner(row, column + 1));
    for (int j = 0; j < points_; ++j) nodes.push_back(on_vertical(row, column + 1, j));
    nodes.push_back(corner(row + 1, column + 1));
    for (int j = points_; j-- > 0;) nodes.push_back(on_horizontal(row + 1, column, j));
    nodes.push_back(corner(row + 1, column));
    for (int j = points_; j-- > 0;) nodes.push_back(on_vertical(row, column, j));
  }

  Eigen::Vector2d place(int node) const {
    if (node < vertical_) return {map_.line(0, node % (columns_ + 1)), map_.line(1, node / (columns_ + 1))};
    if (node < horizontal_) {
      const int k = node - vertical_, side = k / points_, row = side / (columns_ + 1);
      return {map_.line(0, side % (columns_ + 1)), between(1, row, k % points_)};
    }
    const int k = node - horizontal_, side = k / points_;
    return {between(0, side % columns_, k % points_), map_.line(1, side / columns_)};
  }

  /// Calls visit(row, column) for the cells that a node touches.
  template <class Visit>
  void each_cell(int node, const Visit& visit) const {
    if (node < vertical_) {
      const int column = node % (columns_ + 1), row = node / (columns_ + 1);
      return each_of(row - 1, row, column - 1, column, visit);
    }
    if (node < horizontal_) {
      const int side = (node - vertical_) / points_, column = side % (columns_ + 1), row = side / (columns_ + 1);
      return each_of(row, row, column - 1, column, visit);
    }
    const int side = (node - horizontal_) / points_, column = side % columns_, row = side / columns_;
    each_of(row - 1, row, column, column, visit);
  }

 private:
  int corner(int row, int column) const { return row * (columns_ + 1) + column; }
  int on_vertical(int row, int line, int j) const { return vertical_ + (row * (columns_ + 1) + line) * points_ + j; }
  int on_horizontal(int line, int column, int j) const {
    return horizontal_ + (line * columns_ + column) * points_ + j;
  }
  double between(int axis, int cell, int j) const {
    const double low = map_.line(axis, cell), high = map_.line(axis, cell + 1);
    return low + (high - low) * (j + 1) / (points_ + 1);
  }
  template <class Visit>
  void each_of(int first_row, int last_row, int first_column, int last_column, const Visit& visit) const {
    for (int row = first_row; row <= last_row; ++row)
      for (int column = first_column; column <= last_column; ++column)
        if (row >= 0 && column >= 0 && row < rows_ && column < columns_) visit(row, column);
  }

  const CellMap& map_;
  int points_, columns_, rows_, vertical_, horizontal_;
};

}  // namespace leastcost
