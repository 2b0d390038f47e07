// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/distance/grid_shape.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {
namespace {

using Counts = Eigen::Array3d;

/// Cells along each axis, a multiple of four. As doubles: a cell that is far too small must not overflow.
Counts cells_along(const Eigen::AlignedBox3d& box, double cell, int margin) {
  return 4 * ((box.sizes().array() / cell + 2 * margin) / 4).ceil();
}

double nodes_of(const Counts& cells) { return (cells + 1).prod(); }

/// The smallest cell, to two digits, with which the grid fits.
double cell_that_fits(const Eigen::AlignedBox3d& box, double too_small, int margin, double memory) {
  double low = too_small, high = too_small;
  const auto fits = [&](double cell) { return kBytesPerNode * nodes_of(cells_along(box, cell, margin)) <= memory; };
  while (!fits(high)) {
    high *= 2;
    if (high > 1e3 * box.sizes().maxCoeff()) return std::numeric_limits<double>::quiet_NaN();
  }
  for (int i = 0; i < 30; ++i) (fits((low + high) / 2) ? high : low) = (low + high) / 2;
  const double digit = std::pow(10, std::floor(std::log10(high)) - 1);
  return digit * std::ceil(high / digit);
}

std::string too_large(const Eigen::AlignedBox3d& box, double cell, int margin, double memory) {
  const Counts cells = cells_along(box, cell, margin);
  const double fitting = cell_that_fits(box, cell, margin, memory);
  std::ostringstream out;
  out.precision(6);
  out << "a grid of " << cells[0] << " x " << cells[1] << " x " << cells[2] << " cells of " << cell << " takes "
      << bytes_in_words(kBytesPerNode * nodes_of(cells)) << " to build, more than the memory limit of "
      << bytes_in_words(memory);
  if (std::isfinite(fitting))
    out << ": a cell of " << fitting << " fits";
  else
    out << ", which is too small for any grid";
  return out.str();
}

}  // namespace

std::string bytes_in_words(double bytes) {
  std::ostringstream out;
  out.precision(3);
  if (bytes < 0x1p20)
    out << bytes / 0x1p10 << " KiB";
  else if (bytes < 0x1p30)
    out << bytes / 0x1p20 << " MiB";
  else
    out << bytes / 0x1p30 << " GiB";
  return out.str();
}

GridShape every_second(const GridShape& shape) {
  GridShape half = shape;
  half.cell *= 2;
  for (int& count : half.count) count = (count + 1) / 2;
  if (*std::min_element(half.count.begin(), half.count.end()) < GridShape::kFewest)
    throw InputError("the distance grid is too small for a coarser version: " + text(shape));
  return half;
}

std::string text(const GridShape& shape) {
  std::ostringstream out;
  out.precision(4);
  out << shape.count[0] << " x " << shape.count[1] << " x " << shape.count[2] << " nodes, cell " << shape.cell << ", "
      << bytes_in_words(static_cast<double>(shape.nodes()) * sizeof(double));
  return out.str();
}

GridShape grid_around(const Eigen::AlignedBox3d& box, double cell, int margin, double memory) {
  if (!(cell > 0) || !std::isfinite(cell)) throw OptionError("cell", "must be positive and finite");
  if (box.isEmpty() || !box.sizes().allFinite()) throw InputError("the box of a distance grid is empty or not finite");
  const Counts cells = cells_along(box, cell, margin);
  if (!(kBytesPerNode * nodes_of(cells) <= memory)) throw InputError(too_large(box, cell, margin, memory));
  GridShape shape;
  shape.cell = cell;
  for (std::size_t axis = 0; axis < 3; ++axis)
    shape.count[axis] = static_cast<int>(cells[static_cast<Eigen::Index>(axis)]) + 1;
  shape.origin = box.center() - (cell / 2) * cells.matrix();
  return shape;
}

}  // namespace leastcost
