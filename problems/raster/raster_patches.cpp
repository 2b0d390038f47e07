// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/raster_patches.hpp"

#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "framework/base/sound_size.hpp"

namespace leastcost {
namespace {

/// Of a place `x` from 0 to `count`: the cells it lies in, one, or two where it is on the line between them.
std::pair<int, int> cells_at(double x, int count) {
  const int cell = std::min(static_cast<int>(x), count - 1);
  return {x == cell && cell > 0 ? cell - 1 : cell, cell};
}

}  // namespace

void check_sound_cells(const RasterGrid& raster) {
  for (const double side : raster.cell) check_sound_size(raster.source + ": the side of a cell", side);
}

RasterPatches::RasterPatches(const RasterGrid& raster, int reach, int fewest)
    : rows_(raster.rows - 1),
      columns_(raster.columns - 1),
      cell_(raster.cell),
      lower_(raster.place(0, 0)),
      source_(raster.source) {
  check_sound_cells(raster);
  if (raster.rows < fewest || raster.columns < fewest)
    throw InputError(source_ + ": " + std::to_string(raster.rows) + " x " + std::to_string(raster.columns) +
                     " cells; at least " + std::to_string(fewest) + " x " + std::to_string(fewest) + " are needed");
  known_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), true);
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column) {
      if (std::isfinite(raster.value(row, column))) continue;
      for (int r = std::max(0, row - 1 - reach); r <= std::min(rows_ - 1, row + reach); ++r)
        for (int c = std::max(0, column - 1 - reach); c <= std::min(columns_ - 1, column + reach); ++c)
          known_[index(r, c)] = false;
    }
  if (std::find(known_.begin(), known_.end(), true) == known_.end())
    throw InputError(source_ + ": no point has data on all sides");
}

std::optional<RasterPatch> RasterPatches::at(double column, double row) const {
  if (!inside(column, row)) return std::nullopt;
  const auto [left, right] = cells_at(column, columns_);
  const auto [below, above] = cells_at(row, rows_);
  for (const int r : {above, below})
    for (const int c : {right, left})
      if (known_[index(r, c)]) return RasterPatch{r, c};
  return std::nullopt;
}

std::string RasterPatches::why_unknown(double x, double y) const {
  const Eigen::Vector2d place(x, y), cells = in_cells(x, y);
  if (!inside(cells[0], cells[1]))
    return point_text(place, 9) + " is outside the values of " + source_ + ", which extend from " +
           point_text(lower_, 9) + " to " + point_text(upper(), 9);
  if (at(cells[0], cells[1])) return "";
  const int row = std::min(static_cast<int>(cells[1]), rows_ - 1),
            column = std::min(static_cast<int>(cells[0]), columns_ - 1);
  return "near " + point_text(place, 9) + ", at row " + std::to_string(rows_ - row) + ", column " +
         std::to_string(column) + " of " + source_ + " (from 0), there is no data";
}

}  // namespace leastcost
