// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/plot/contour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace leastcost::app {
namespace {

struct Corner {
  double x, y, value;
};

/// The four corners of a cell, counterclockwise.
std::array<Corner, 4> corners_of(const Grid& grid, int i, int j) {
  return {{{i + 0.0, j + 0.0, grid.at(i, j)},
           {i + 1.0, j + 0.0, grid.at(i + 1, j)},
           {i + 1.0, j + 1.0, grid.at(i + 1, j + 1)},
           {i + 0.0, j + 1.0, grid.at(i, j + 1)}}};
}

/// The part of a cell above the level: its boundary is walked once, and where it passes the level a corner is put in.
/// (At a saddle the two parts are joined, which no one sees at this size.)
std::string part_above(const std::array<Corner, 4>& c, double level, const ToDrawing& x, const ToDrawing& y) {
  std::string d;
  const auto add = [&](double px, double py) {
    fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", d.empty() ? "M" : "L", x(px), y(py));
  };
  for (std::size_t k = 0; k < 4; ++k) {
    const Corner &a = c[k], &b = c[(k + 1) % 4];
    if (a.value >= level) add(a.x, a.y);
    if ((a.value >= level) == (b.value >= level)) continue;
    double t = (level - a.value) / (b.value - a.value);
    if (std::isinf(b.value)) t = 1;
    if (std::isinf(a.value)) t = 0;
    add(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
  }
  return d.empty() ? "" : d + "Z";
}

/// Where the level passes through a cell: one line, or at a saddle two.
std::string line_through(const std::array<Corner, 4>& c, double level, const ToDrawing& x, const ToDrawing& y) {
  std::string d;
  int ends = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Corner &a = c[k], &b = c[(k + 1) % 4];
    if ((a.value >= level) == (b.value >= level)) continue;
    const double t = (level - a.value) / (b.value - a.value);
    fmt::format_to(std::back_inserter(d), "{}{:.1f} {:.1f}", ends++ % 2 == 0 ? "M" : "L", x(a.x + t * (b.x - a.x)),
                   y(a.y + t * (b.y - a.y)));
  }
  return d;
}

/// A rectangle of whole cells, from column i to column i_end of row j.
std::string run_of_cells(int i, int i_end, int j, const ToDrawing& x, const ToDrawing& y) {
  return fmt::format("M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z", x(i), y(j), x(i_end), y(j + 1), x(i));
}

/// Walks over all cells. \`whole\` says whether a cell is filled as a whole; \`part\` draws the others.
template <class Whole, class Part>
std::string over_cells(const Grid& grid, const ToDrawing& x, const ToDrawing& y, Whole whole, Part part) {
  std::string d;
  for (int j = 0; j + 1 < grid.rows; ++j) {
    int start = 0;
    for (int i = 0; i + 1 < grid.columns; ++i) {
      const std::array<Corner, 4> c = corners_of(grid, i, j);
      if (whole(c)) continue;
      if (i > start) d += run_of_cells(start, i, j, x, y);
      start = i + 1;
      d += part(c);
    }
    if (grid.columns - 1 > start) d += run_of_cells(start, grid.columns - 1, j, x, y);
  }
  return d;
}

}  // namespace

std::string region_above(const Grid& grid, double level, const ToDrawing& x, const ToDrawing& y) {
  return over_cells(
      grid, x, y,
      [level](const std::array<Corner, 4>& c) {
        return c[0].value >= level && c[1].value >= level && c[2].value >= level && c[3].value >= level;
      },
      [&](const std::array<Corner, 4>& c) { return part_above(c, level, x, y); });
}

std::string line_at(const Grid& grid, double level, const ToDrawing& x, const ToDrawing& y) {
  std::string d;
  for (int j = 0; j + 1 < grid.rows; ++j)
    for (int i = 0; i + 1 < grid.columns; ++i) {
      const std::array<Corner, 4> c = corners_of(grid, i, j);
      if (std::all_of(c.begin(), c.end(), [](const Corner& corner) { return std::isfinite(corner.value); }))
        d += line_through(c, level, x, y);
    }
  return d;
}

std::string region_infinite(const Grid& grid, const ToDrawing& x, const ToDrawing& y) {
  return over_cells(
      grid, x, y,
      [](const std::array<Corner, 4>& c) {
        return std::isinf(c[0].value) || std::isinf(c[1].value) || std::isinf(c[2].value) || std::isinf(c[3].value);
      },
      [](const std::array<Corner, 4>&) { return std::string(); });
}

}  // namespace leastcost::app
