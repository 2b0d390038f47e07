// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <deque>

#include "problems/raster/raster_function.hpp"
#include "problems/spline/bspline_line.hpp"
#include "problems/spline/spline_part.hpp"

namespace leastcost {
namespace {

/// Second derivatives of the weights of BsplineWeights.
std::array<double, 4> bend_weights(double u) { return {1 - u, 3 * u - 2, 1 - 3 * u, u}; }

template <std::size_t N, std::size_t Rows>
using Table = std::array<std::array<Interval, N>, Rows>;

/// The column of a table.
template <std::size_t N, std::size_t Rows>
std::array<Interval, Rows> column_of(const Table<N, Rows>& table, std::size_t k) {
  std::array<Interval, Rows> out;
  for (std::size_t j = 0; j < Rows; ++j) out[j] = table[j][k];
  return out;
}

/// Bounds of a function of two variables by the B-spline coefficients around a part of a patch.
template <std::size_t P, std::size_t Q>
Interval range_of(const Table<P + 1, Q + 1>& around, const SplinePart<P>& along, const SplinePart<Q>& across) {
  Table<P + 1, Q + 1> rows;
  for (std::size_t j = 0; j <= Q; ++j) rows[j] = along.bernstein(around[j]);
  Interval out = across.range(column_of(rows, 0));
  for (std::size_t k = 1; k <= P; ++k) out = hull(out, across.range(column_of(rows, k)));
  return out;
}

/// The same at a place, by the weights there.
template <std::size_t P, std::size_t Q>
Interval value_of(const Table<P + 1, Q + 1>& around, const std::array<Interval, P + 1>& along,
                  const std::array<Interval, Q + 1>& across) {
  Interval out;
  for (std::size_t j = 0; j <= Q; ++j) {
    Interval row = along[0] * around[j][0];
    for (std::size_t k = 1; k <= P; ++k) row += along[k] * around[j][k];
    out = j == 0 ? across[j] * row : out + across[j] * row;
  }
  return out;
}

template <std::size_t N, std::size_t Rows>
Table<N - 1, Rows> differences_along(const Table<N, Rows>& table) {
  Table<N - 1, Rows> out;
  for (std::size_t j = 0; j < Rows; ++j) out[j] = differences(table[j]);
  return out;
}

/// Of neighbouring rows.
template <std::size_t N, std::size_t Rows>
Table<N, Rows - 1> differences_across(const Table<N, Rows>& table) {
  Table<N, Rows - 1> out;
  for (std::size_t j = 0; j + 1 < Rows; ++j)
    for (std::size_t k = 0; k < N; ++k) out[j][k] = table[j + 1][k] - table[j][k];
  return out;
}

/// The 16 coefficients around a patch.
Table<4, 4> table_at(const double* first, std::size_t width) {
  Table<4, 4> out;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t k = 0; k < 4; ++k) out[j][k] = Interval(first[j * width + k]);
  return out;
}

/// A range along an axis as parts of the three splines: of the values, their slopes and their bends.
struct SplineParts {
  SplinePart<3> value;
  SplinePart<2> slope;
  SplinePart<1> bend;

  SplineParts(const Interval& range, int patch)
      : SplineParts(Interval(range.lo) - Interval(patch), Interval(range.hi) - Interval(patch)) {}

 private:
  SplineParts(const Interval& from, const Interval& to) : value(from, to), slope(from, to), bend(from, to) {}
};

/// The values in an array with one more on every side; `width` of its rows.
std::vector<double> padded(const RasterGrid& raster, std::size_t width) {
  std::vector<double> all(width * (static_cast<std::size_t>(raster.rows) + 2));
  for (int row = 0; row < raster.rows; ++row)
    std::copy_n(&raster.values[raster.index(row, 0)], raster.columns,
                &all[(static_cast<std::size_t>(row) + 1) * width + 1]);
  return all;
}

std::size_t width_of(const RasterGrid& raster) { return static_cast<std::size_t>(raster.columns) + 2; }

/// Values where there are none, ring by ring: the mean of the neighbours that have one.
void fill_gaps(RasterGrid& raster) {
  struct Cell {
    int row, column;
  };
  const auto neighbours = [&raster](const Cell& at, const auto& visit) {
    for (int r = std::max(0, at.row - 1); r <= std::min(raster.rows - 1, at.row + 1); ++r)
      for (int c = std::max(0, at.column - 1); c <= std::min(raster.columns - 1, at.column + 1); ++c) visit(Cell{r, c});
  };
  std::vector<bool> waits(raster.values.size(), false);
  std::vector<Cell> ring;
  const auto await = [&](const Cell& cell) {
    const std::size_t i = raster.index(cell.row, cell.column);
    if (waits[i] || std::isfinite(raster.values[i])) return;
    waits[i] = true;
    ring.push_back(cell);
  };
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column)
      if (std::isfinite(raster.value(row, column))) neighbours({row, column}, await);
  while (!ring.empty()) {
    std::vector<double> means;
    for (const Cell& cell : ring) {
      double sum = 0, count = 0;
      neighbours(cell, [&](const Cell& other) {
        const double value = raster.value(other.row, other.column);
        if (std::isfinite(value)) sum += value, ++count;
      });
      means.push_back(sum / count);
    }
    const std::vector<Cell> filled = std::exchange(ring, {});
    for (std::size_t i = 0; i < filled.size(); ++i)
      raster.values[raster.index(filled[i].row, filled[i].column)] = means[i];
    for (const Cell& cell : filled) neighbours(cell, await);
  }
}

}  // namespace

SplineFunction::SplineFunction(RasterPatches patches, std::vector<double> coefficients)
    : RasterFunction(std::move(patches)),
      width_(static_cast<std::size_t>(this->patches().columns()) + 3),
      coefficients_(std::move(coefficients)) {}

SplineFunction SplineFunction::through(const RasterGrid& raster) {
  RasterPatches patches(raster, 1, kFewestOfSpline);
  RasterGrid filled = raster;
  fill_gaps(filled);
  const std::size_t width = width_of(filled);
  std::vector<double> c = padded(filled, width);
  for (int row = 0; row < filled.rows; ++row)
    to_bspline_coefficients(&c[(static_cast<std::size_t>(row) + 1) * width + 1], filled.columns, 1, 1);
  to_bspline_coefficients(&c[width], filled.rows, width, width);
  return {std::move(patches), std::move(c)};
}

SplineFunction SplineFunction::near(const RasterGrid& raster) {
  RasterPatches patches(raster, 1, 2);
  const std::size_t width = width_of(raster), rows = static_cast<std::size_t>(raster.rows);
  std::vector<double> c = padded(raster, width);
  for (std::size_t row = 1; row <= rows; ++row) {  // beyond the border the outermost values go on
    c[row * width] = c[row * width + 1];
    c[row * width + width - 1] = c[row * width + width - 2];
  }
  std::copy_n(&c[width], width, &c[0]);
  std::copy_n(&c[rows * width], width, &c[(rows + 1) * width]);
  return {std::move(patches), std::move(c)};
}

PlaneJet SplineFunction::in_patch(const RasterPatch& patch, double column, double row) const {
  const double u = column - patch.column, v = row - patch.row;
  const BsplineWeights across(u), up(v);
  const std::array<double, 4> across_bends = bend_weights(u), up_bends = bend_weights(v);
  const double* c = coefficients_of(patch);
  PlaneJet jet;
  double dx = 0, dy = 0, dxx = 0, dxy = 0, dyy = 0;
  for (std::size_t j = 0; j < 4; ++j, c += width_) {
    double line = 0, slope = 0, bend = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      line += across.w[i] * c[i];
      slope += across.d[i] * c[i];
      bend += across_bends[i] * c[i];
    }
    jet.value += up.w[j] * line;
    dx += up.w[j] * slope;
    dy += up.d[j] * line;
    dxx += up.w[j] * bend;
    dxy += up.d[j] * slope;
    dyy += up_bends[j] * line;
  }
  const double hx = patches().cell()[0], hy = patches().cell()[1];
  jet.gradient << dx / hx, dy / hy;
  jet.hessian << dxx / (hx * hx), dxy / (hx * hy), dxy / (hx * hy), dyy / (hy * hy);
  return jet;
}

/// A spline lies between its least and its largest coefficient, and its slope is a spline of their differences.
PatchBounds SplineFunction::bounds(const RasterPatch& patch) const {
  const double* c = coefficients_of(patch);
  const Interval hx(patches().cell()[0]), hy(patches().cell()[1]);
  const auto slope = [](double from, double to, const Interval& h) { return (Interval(to) - Interval(from)) / h; };
  PatchBounds out{c[0], slope(c[0], c[1], hx), slope(c[0], c[width_], hy)};
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i) {
      const double* at = c + j * width_ + i;
      out.value = hull(out.value, *at);
      if (i < 3) out.dx = hull(out.dx, slope(at[0], at[1], hx));
      if (j < 3) out.dy = hull(out.dy, slope(at[0], at[width_], hy));
    }
  return out;
}

PatchBounds SplineFunction::enclose(const RasterPatch& patch, const Interval& column, const Interval& row) const {
  const Interval u = column - Interval(patch.column), v = row - Interval(patch.row);
  const std::array<Interval, 4> along = polar_weights(std::array{u, u, u}), across = polar_weights(std::array{v, v, v});
  const Table<4, 4> c = table_at(coefficients_of(patch), width_);
  return {
      value_of<3, 3>(c, along, across),
      value_of<2, 3>(differences_along(c), polar_weights(std::array{u, u}), across) / Interval(patches().cell()[0]),
      value_of<3, 2>(differences_across(c), along, polar_weights(std::array{v, v})) / Interval(patches().cell()[1])};
}

PlaneBends SplineFunction::bends(const RasterPatch& patch, const Interval& column, const Interval& row) const {
  const SplineParts along(column, patch.column), across(row, patch.row);
  const Table<4, 4> c = table_at(coefficients_of(patch), width_);
  const Table<3, 4> steps = differences_along(c);
  return scaled({range_of<1, 3>(differences_along(steps), along.bend, across.value),
                 range_of<2, 2>(differences_across(steps), along.slope, across.slope),
                 range_of<3, 1>(differences_across(differences_across(c)), along.value, across.bend)});
}

PlaneBends SplineFunction::scaled(const PlaneBends& in_cells) const {
  const Interval hx(patches().cell()[0]), hy(patches().cell()[1]);
  return {in_cells.xx / square(hx), in_cells.xy / (hx * hy), in_cells.yy / square(hy)};
}

/// A second derivative is a spline of second differences, and lies between the least and the largest of these.
PlaneBends SplineFunction::bends(const RasterPatch& first, const RasterPatch& last) const {
  const std::size_t rows = static_cast<std::size_t>(last.row - first.row) + 4,
                    columns = static_cast<std::size_t>(last.column - first.column) + 4;
  PlaneBends out;
  const double* c = coefficients_of(first);
  const auto widen = [](Interval& all, const Interval& here, bool is_first) {
    all = is_first ? here : hull(all, here);
  };
  const auto second = [](const double* at, std::size_t step) {
    return (Interval(at[2 * step]) - at[step]) - (Interval(at[step]) - at[0]);
  };
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const double* at = c + j * width_ + i;
      if (i + 2 < columns) widen(out.xx, second(at, 1), i + j == 0);
      if (j + 2 < rows) widen(out.yy, second(at, width_), i + j == 0);
      if (i + 1 < columns && j + 1 < rows)
        widen(out.xy, (Interval(at[width_ + 1]) - at[width_]) - (Interval(at[1]) - at[0]), i + j == 0);
    }
  return scaled(out);
}

}  // namespace leastcost
