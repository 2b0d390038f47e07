// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// How places on a raster in metres, x to the east and y to the north, are places on the Earth.
struct RasterDegrees {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();      ///< longitude and latitude of the place (0, 0), degrees
  Eigen::Vector2d per_degree = Eigen::Vector2d::Zero();  ///< metres along x and along y
};

/// Values on a regular grid in the plane. A value belongs to the middle of its cell; rows count upwards, along y, while
/// files begin with the northernmost one.
struct RasterGrid {
  static constexpr std::int64_t kMostCells = std::int64_t{1} << 27;  ///< that readers take

  int rows = 0, columns = 0;
  Eigen::Vector2d cell = Eigen::Vector2d::Ones();    ///< sides of a cell, > 0, length units
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< lower left corner of cell (0, 0)
  std::vector<double> values;                        ///< rows x columns, row by row; NaN: no data
  std::optional<RasterDegrees> degrees;              ///< where the file was in degrees
  std::string source;                                ///< where it came from, for messages

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  double value(int row, int column) const { return values[index(row, column)]; }
  /// Where value (row, column) stands.
  Eigen::Vector2d place(int row, int column) const {
    return corner + cell.cwiseProduct(Eigen::Vector2d(column + 0.5, row + 0.5));
  }
  /// "row 3, column 7 of dem.asc", rows from the top of the file, both from 0.
  std::string name_of(int row, int column) const;
};

}  // namespace leastcost
