// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// The cells that a place touches along an axis: two beside a line, else one, none outside.
struct CellRange {
  int first = 0, last = -1;
  bool empty() const { return first > last; }
  CellRange common(const CellRange& other) const {
    return {first > other.first ? first : other.first, last < other.last ? last : other.last};
  }
};

/// A straight move within one cell, its sides included.
struct CellLeg {
  int row = 0, column = 0;
  double unit = 0;  ///< cost of a unit of length
  double cost = 0;
};

/// Rectangles between vertical and horizontal lines, in each of which a unit of length costs the same; +infinity where
/// no path leads. A side costs the lower of both beside it. A place is on a line if its coordinate is that of the line,
/// to the last digit.
class CellMap {
 public:
  /// The cells of a raster, those without data infinite.
  explicit CellMap(const RasterGrid& raster);
  /// What of it lies in a box, sides of which may be infinite. Empty where they do not meet.
  CellMap within(const Eigen::AlignedBox2d& box) const;

  int rows() const { return static_cast<int>(y_.size()) - 1; }
  int columns() const { return static_cast<int>(x_.size()) - 1; }
  bool empty() const { return rows() < 1 || columns() < 1; }
  /// Where line k of an axis (0: vertical lines) is.
  double line(int axis, int k) const { return axis == 0 ? x_[as_index(k)] : y_[as_index(k)]; }
  const std::vector<double>& lines(int axis) const { return axis == 0 ? x_ : y_; }
  double unit(int row, int column) const { return units_[as_index(row) * (x_.size() - 1) + as_index(column)]; }
  /// The same, infinite beyond the map.
  double unit_or_none(int row, int column) const {
    const bool inside = row >= 0 && column >= 0 && row < rows() && column < columns();
    return inside ? unit(row, column) : std::numeric_limits<double>::infinity();
  }
  double least_unit() const;

  CellRange touched(int axis, double coordinate) const;
  /// The number of the line of an axis that a coordinate is on.
  std::optional<int> line_at(int axis, double coordinate) const;
  /// The cheapest cell that both places touch; null where there is none, or it is infinite.
  std::optional<CellLeg> leg(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// Why no path begins or ends at a place; empty: one may.
  std::string why_no_end(const Eigen::Vector2d& place) const;

 private:
  CellMap() = default;
  static std::size_t as_index(int k) { return static_cast<std::size_t>(k); }

  std::vector<double> x_ = {0}, y_ = {0};
  std::vector<double> units_;  ///< row by row
  std::string source_;
};

/// Places, each of which shares a cell with the next one.
using CellPath = std::vector<Eigen::Vector2d>;

/// A polyline cut where it crosses lines; what rounding keeps off a line is put on it, but for the ends.
CellPath cut_at_sides(const CellMap& map, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline);
/// Infinite where two neighbours share no cell.
double cost_of(const CellMap& map, const CellPath& path);

}  // namespace leastcost
