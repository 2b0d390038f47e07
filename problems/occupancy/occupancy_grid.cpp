// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/occupancy/occupancy_grid.hpp>

#include <algorithm>

namespace leastcost {
namespace {

/// Whether all cells of a box are blocked.
bool all_blocked(const OccupancyGrid& grid, const CellBox& box) {
  for (int row = box.row; row < box.row_end; ++row)
    for (int column = box.column; column < box.column_end; ++column)
      if (!grid.blocked[grid.index(row, column)]) return false;
  return true;
}

/// Blocked boxes around a blocked cell, grown along its row and then to both sides, or along its column first.
CellBox grown(const OccupancyGrid& grid, int row, int column, bool row_first) {
  CellBox box{row, row + 1, column, column + 1};
  const auto along_row = [&] {
    while (box.column > 0 && all_blocked(grid, {box.row, box.row_end, box.column - 1, box.column})) --box.column;
    while (box.column_end < grid.columns &&
           all_blocked(grid, {box.row, box.row_end, box.column_end, box.column_end + 1}))
      ++box.column_end;
  };
  const auto along_column = [&] {
    while (box.row > 0 && all_blocked(grid, {box.row - 1, box.row, box.column, box.column_end})) --box.row;
    while (box.row_end < grid.rows && all_blocked(grid, {box.row_end, box.row_end + 1, box.column, box.column_end}))
      ++box.row_end;
  };
  if (row_first) along_row();
  along_column();
  if (!row_first) along_row();
  return box;
}

std::int64_t cells_of(const CellBox& box) {
  return std::int64_t{box.row_end - box.row} * (box.column_end - box.column);
}

/// Whether a free cell is among the eight around a cell.
bool beside_free(const OccupancyGrid& grid, int row, int column) {
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = column - 1; c <= column + 1; ++c)
      if (grid.free(r, c)) return true;
  return false;
}

}  // namespace

std::vector<CellBox> free_boxes(const OccupancyGrid& grid) {
  const auto free = [&](int row, int column) { return !grid.blocked[grid.index(row, column)]; };
  std::vector<CellBox> boxes;
  std::vector<std::size_t> above, here;  // the boxes that reach the row before, and this row; ascending by column
  for (int row = 0; row < grid.rows; ++row, above.swap(here)) {
    here.clear();
    auto candidate = above.begin();
    for (int begin = 0; begin < grid.columns;) {
      if (!free(row, begin)) {
        ++begin;
        continue;
      }
      int end = begin + 1;
      while (end < grid.columns && free(row, end)) ++end;
      while (candidate != above.end() && boxes[*candidate].column < begin) ++candidate;
      if (candidate != above.end() && boxes[*candidate].column == begin && boxes[*candidate].column_end == end) {
        boxes[*candidate].row_end = row + 1;
        here.push_back(*candidate);
      } else {
        here.push_back(boxes.size());
        boxes.push_back({row, row + 1, begin, end});
      }
      begin = end;
    }
  }
  return boxes;
}

std::vector<CellBox> blocking_boxes(const OccupancyGrid& grid) {
  std::vector<bool> covered(grid.blocked.size(), false);
  std::vector<CellBox> boxes;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (grid.free(row, column) || covered[grid.index(row, column)] || !beside_free(grid, row, column)) continue;
      const CellBox wide = grown(grid, row, column, true), tall = grown(grid, row, column, false);
      const CellBox& box = cells_of(wide) >= cells_of(tall) ? wide : tall;
      for (int r = box.row; r < box.row_end; ++r)
        for (int c = box.column; c < box.column_end; ++c) covered[grid.index(r, c)] = true;
      boxes.push_back(box);
    }
  return boxes;
}

}  // namespace leastcost
