// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/numbers/dual.hpp>
#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// A rectangle between four neighbouring values of a raster: those of (row, column), (row, column + 1) and the two
/// above.
struct RasterPatch {
  int row = 0, column = 0;
};

/// Throws InputError for sides of cells beyond the lengths of sound_size.hpp.
void check_sound_cells(const RasterGrid& raster);

/// The rectangles between the values of a raster, and where a function through the values is known: nowhere beyond the
/// outermost values, and not where a value is missing that it needs there.
class RasterPatches {
 public:
  /// `reach`: how many rings of values beyond its four corners a patch needs (0: bilinear, 1: bicubic); values beyond
  /// the border of the raster are not asked for. Throws InputError for a raster of fewer than `fewest` rows or columns,
  /// or without any patch.
  RasterPatches(const RasterGrid& raster, int reach, int fewest);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  const Eigen::Vector2d& cell() const { return cell_; }
  const Eigen::Vector2d& lower() const { return lower_; }
  Eigen::Vector2d upper() const { return lower_ + cell_.cwiseProduct(Eigen::Vector2d(columns_, rows_)); }
  Eigen::Vector2d corner(int row, int column) const {
    return lower_ + cell_.cwiseProduct(Eigen::Vector2d(column, row));
  }
  bool known(int row, int column) const {
    return row >= 0 && row < rows_ && column >= 0 && column < columns_ && known_[index(row, column)];
  }
  /// The place in sides of a cell from the lowest value.
  template <class S>
  Eigen::Matrix<S, 2, 1> in_cells(const S& x, const S& y) const {
    return {S((x - lower_[0]) / cell_[0]), S((y - lower_[1]) / cell_[1])};
  }
  /// Up to rounding: a bound of the domain may be computed in another way.
  bool inside(double column, double row) const {
    constexpr double kRounding = 1e-9;
    return column >= -kRounding && column <= columns_ + kRounding && row >= -kRounding && row <= rows_ + kRounding;
  }
  /// A known patch that a place (in cells) lies in, its border included.
  std::optional<RasterPatch> at(double column, double row) const;
  /// Why there is none, with the place.
  std::string why_unknown(double x, double y) const;

  /// Cuts the straight line from a to b (in cells) at the borders of patches and calls visit(patch, from, to) for every
  /// piece in turn, `from` and `to` being parameters from 0 to 1 with their derivatives by a and b. False, at once,
  /// where a piece is in no known patch.
  template <class S, class Visit>
  bool cut(const Eigen::Matrix<S, 2, 1>& a, const Eigen::Matrix<S, 2, 1>& b, const Visit& visit) const {
    const double x0 = innermost(a[0]), y0 = innermost(a[1]), x1 = innermost(b[0]), y1 = innermost(b[1]);
    if (!inside(x0, y0) || !inside(x1, y1)) return false;
    Crossings across_x(x0, x1), across_y(y0, y1);
    S from(0.0);
    for (bool last = false; !last;) {
      const double tx = across_x.next(), ty = across_y.next();
      last = !(tx < 1) && !(ty < 1);
      const int axis = tx < ty ? 0 : 1;
      Crossings& crossed = axis == 0 ? across_x : across_y;
      const S to = last ? S(1.0) : S((S(crossed.line) - a[axis]) / (b[axis] - a[axis]));
      if (!last) crossed.advance();
      const double middle = 0.5 * (innermost(from) + innermost(to));
      if (innermost(to) > innermost(from)) {
        const std::optional<RasterPatch> patch = at(x0 + middle * (x1 - x0), y0 + middle * (y1 - y0));
        if (!patch) return false;
        visit(*patch, from, to);
      }
      from = to;
    }
    return true;
  }

 private:
  /// Whole numbers strictly between two others, in their order, as parameters.
  struct Crossings {
    Crossings(double a, double b) : start(a), end(b), line(b > a ? std::floor(a) + 1 : std::ceil(a) - 1) {}
    double next() const {
      const bool between = end > start ? line < end : line > end;
      return between && end != start ? (line - start) / (end - start) : std::numeric_limits<double>::infinity();
    }
    void advance() { line += end > start ? 1 : -1; }
    double start, end, line;
  };

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  int rows_, columns_;
  Eigen::Vector2d cell_, lower_;
  std::vector<bool> known_;
  std::string source_;
};

}  // namespace leastcost
