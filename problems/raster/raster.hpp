// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
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

/// The coordinate reference system of a raster file.
struct RasterCrs {
  using Transform = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;
  std::string name;         ///< of the CRS, in words
  std::string wkt = {};     ///< the CRS in full (WKT 2), x or longitude first; empty where the build cannot say it
  bool geographic = false;  ///< its places are longitude and latitude, degrees
  /// From its places (x, y) to longitude and latitude on WGS84, and back; not finite where that fails. Empty where the
  /// build cannot transform: degrees are then taken as they are.
  Transform to_wgs84 = {}, from_wgs84 = {};
};

/// Values on a regular grid in the plane. A value belongs to the middle of its cell; rows count upwards, along y, while
/// files begin with the northernmost one.
struct RasterGrid {
  static constexpr std::int64_t kMostCells = std::int64_t{1} << 27;  ///< that readers take

  int rows = 0, columns = 0;                         ///< cells upwards and to the right
  Eigen::Vector2d cell = Eigen::Vector2d::Ones();    ///< sides of a cell, > 0, length units
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< lower left corner of cell (0, 0)
  std::vector<double> values;                        ///< rows x columns, row by row; NaN: no data
  std::optional<RasterDegrees> degrees;              ///< where the file was in degrees
  std::shared_ptr<const RasterCrs> crs;              ///< null: not known
  std::string source;                                ///< where it came from, for messages

  /// Of a cell in arrays, the lowest row first.
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  double value(int row, int column) const { return values[index(row, column)]; }  ///< of a cell; NaN: no data
  /// Where value (row, column) stands.
  Eigen::Vector2d place(int row, int column) const {
    return corner + cell.cwiseProduct(Eigen::Vector2d(column + 0.5, row + 0.5));
  }
  /// Whether places on the raster are places on the Earth.
  bool on_earth() const { return degrees || (crs && crs->to_wgs84 && crs->from_wgs84); }
  /// Longitude and latitude of a place, degrees, on WGS84 where the file says on which ellipsoid it is.
  Eigen::Vector2d longitude_latitude(const Eigen::Vector2d& place) const;
  /// The place of a longitude and a latitude, under whatever name of the longitude; may lie beyond the raster.
  Eigen::Vector2d place_of(const Eigen::Vector2d& longitude_latitude) const;
  /// What a user should know about where places are; may be empty.
  std::string place_note() const;
  /// "row 3, column 7 of dem.asc", rows from the top of the file, both from 0.
  std::string name_of(int row, int column) const;
};

}  // namespace leastcost
