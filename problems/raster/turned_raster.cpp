// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/turned_raster.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix2d, Eigen::Vector2d;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 1e-9;  // of a cell

/// Sides of cells along the axes, so small that no row and no column of the file is crossed between two of them that
/// only meet at a corner: |r_x| width + |r_y| height <= 1 for both rows r of `to_index` (places to columns and rows of
/// the file). A wall that is one cell wide then stays one, and every cell of the file keeps a middle.
Vector2d upright_cell(const Matrix2d& to_index) {
  const Vector2d sides(1 / to_index.col(0).norm(), 1 / to_index.col(1).norm());
  const Matrix2d across = to_index.cwiseAbs() * sides.asDiagonal();
  const bool quarter_turn = across.rowwise().minCoeff().maxCoeff() <= kRounding;
  return sides / across.rowwise().sum().maxCoeff() * (quarter_turn ? 1 : 1 - kRounding);
}

/// The empty grid around the outline of the file.
RasterGrid upright_grid(const RasterGrid& file, const RasterFile::Affine& to_place) {
  const Matrix2d sides = to_place.leftCols<2>();
  RasterGrid out;
  out.cell = upright_cell(sides.inverse());
  const Vector2d far = sides.cwiseAbs() * Vector2d(file.columns, file.rows);  // of the outline, along x and y
  const Vector2d middle = to_place.col(2) + sides * Vector2d(0.5 * file.columns, 0.5 * file.rows);
  const Vector2d counts = (far.cwiseQuotient(out.cell).array() - kRounding).ceil().max(1);
  if (!(counts.prod() <= static_cast<double>(RasterGrid::kMostCells)))
    throw InputError(file.source + ": the raster is rotated; read along the axes it would have " +
                     short_number(counts.prod(), 3) + " cells, but at most " + std::to_string(RasterGrid::kMostCells) +
                     " can be read");
  out.columns = static_cast<int>(counts[0]);
  out.rows = static_cast<int>(counts[1]);
  out.corner = middle - 0.5 * counts.cwiseProduct(out.cell);
  out.crs = file.crs;
  out.source = file.source + " (turned)";
  return out;
}

/// `index`: column and row, whole numbers at the lower left corners of cells.
double nearest_value(const RasterGrid& file, const Vector2d& index) {
  const Vector2d at = index.array().floor();
  if (!(at.minCoeff() >= 0 && at[0] < file.columns && at[1] < file.rows)) return kNone;
  return file.value(static_cast<int>(at[1]), static_cast<int>(at[0]));
}

double bilinear_value(const RasterGrid& file, const Vector2d& index) {
  const Vector2d last(file.columns - 1, file.rows - 1);
  const Vector2d given = index.array() - 0.5;
  const Vector2d at = given.cwiseMax(0).cwiseMin(last);
  if (!((given - at).cwiseAbs().maxCoeff() <= kRounding)) return kNone;  // beyond the outermost middles
  const Vector2d low = at.array().floor(), part = at - low;
  double value = 0, weights = 0;
  for (const int up : {0, 1})
    for (const int right : {0, 1}) {
      const double weight = (right ? part[0] : 1 - part[0]) * (up ? part[1] : 1 - part[1]);
      if (weight <= kRounding) continue;
      weights += weight;
      value += weight * file.value(static_cast<int>(low[1]) + up, static_cast<int>(low[0]) + right);
    }
  return value / weights;
}

std::string note_of(const RasterGrid& file, const RasterFile::Affine& to_place, const RasterGrid& out,
                    Resampling resampling) {
  const double degrees = std::atan2(to_place(1, 0), to_place(0, 0)) * 180 / std::numbers::pi;
  return file.source + " is rotated by " + short_number(degrees, 3) + " degrees: it is read on " +
         std::to_string(out.columns) + " x " + std::to_string(out.rows) + " cells along the axes, " +
         (resampling == Resampling::nearest ? "each with the value of the file's cell at its centre"
                                            : "with values interpolated between the file's") +
         "; cells outside the file have no data";
}

}  // namespace

RasterGrid placed_upright(RasterFile file, const RasterOptions& options, Resampling resampling, std::string& note) {
  if (!file.turned) return placed(std::move(file), options, &note);
  const RasterFile::Affine to_place = *std::exchange(file.turned, std::nullopt);
  const Matrix2d sides = to_place.leftCols<2>();
  if (options.cell && options.origin) return placed(std::move(file), options, &note);
  if (options.cell || options.origin)
    throw OptionError(options.cell ? "cell" : "origin",
                      file.raster.source + " is rotated: give both cell and origin, or neither");
  // As if it were upright, about its middle: what cannot be is found before values are mixed.
  file.raster.cell << sides.col(0).norm(), sides.col(1).norm();
  const Vector2d half(0.5 * file.raster.columns, 0.5 * file.raster.rows);
  file.raster.corner = to_place.col(2) + sides * half - file.raster.cell.cwiseProduct(half);
  std::string fill;
  const RasterGrid read = placed(std::move(file), options, &fill);
  if (resampling == Resampling::bilinear) check_heights(read, options);

  RasterGrid out = upright_grid(read, to_place);
  out.values.resize(static_cast<std::size_t>(out.rows) * static_cast<std::size_t>(out.columns));
  const Matrix2d to_index = sides.inverse();
  for (int row = 0; row < out.rows; ++row)
    for (int column = 0; column < out.columns; ++column) {
      const Vector2d index = to_index * (out.place(row, column) - to_place.col(2));
      out.values[out.index(row, column)] =
          resampling == Resampling::nearest ? nearest_value(read, index) : bilinear_value(read, index);
    }
  note = (fill.empty() ? "" : fill + "; ") + note_of(read, to_place, out, resampling);
  RasterOptions rest = options;  // the values are read and scaled
  rest.nodata.reset();
  rest.value_scale = 1;
  return placed({std::move(out), {}, {}}, rest);
}

}  // namespace leastcost
