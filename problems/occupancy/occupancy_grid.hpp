// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// Which square cells of a rectangle in the plane are blocked. Cell (row, column) covers origin + cell * ([column,
/// column + 1] x [row, row + 1]): rows count along y. What lies outside of the rectangle is blocked.
struct OccupancyGrid {
  static constexpr std::int64_t kMostCells = std::int64_t{1} << 27;  ///< that readers take

  int rows = 0, columns = 0;                         ///< cells upwards and to the right
  double cell = 1;                                   ///< side of a cell, length units
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< lower corner of cell (0, 0)
  std::vector<bool> blocked;                         ///< rows x columns, row by row
  std::vector<bool> unknown = {};                    ///< those of which the map does not know; empty: none
  std::string source;                                ///< where it came from, for messages

  /// Of a cell in arrays.
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  /// Whether a cell is there and not occupied.
  bool free(int row, int column) const {
    return row >= 0 && row < rows && column >= 0 && column < columns && !blocked[index(row, column)];
  }
  /// The lower corner of a cell, which may be one past the last.
  Eigen::Vector2d corner(int row, int column) const { return origin + cell * Eigen::Vector2d(column, row); }
};

/// Cells [row, row_end) x [column, column_end).
struct CellBox {
  int row = 0, row_end = 0, column = 0, column_end = 0;  ///< without the ends
};

/// The free cells as boxes without overlap: the runs of every row from wall to wall, equal runs of consecutive rows
/// merged. To the left and right of a box all is blocked. Ascending by row, then by column.
std::vector<CellBox> free_boxes(const OccupancyGrid& grid);

/// Boxes of blocked cells, each grown as far as it goes, that hold every blocked cell with a free one among its eight
/// neighbours; they may overlap. A path from a free place would touch these before any other; the border of the grid is
/// none of them.
std::vector<CellBox> blocking_boxes(const OccupancyGrid& grid);

}  // namespace leastcost
