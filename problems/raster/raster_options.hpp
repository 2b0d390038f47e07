// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// A raster file, and what of its georeference the file does not say, or says otherwise.
struct RasterOptions {
  std::string file = {};                       ///< ESRI grid, table or, with GDAL, any raster
  std::optional<Eigen::VectorXd> cell = {};    ///< one side, or one along x and one along y
  std::optional<Eigen::VectorXd> origin = {};  ///< lower left corner of the lower left cell
  std::optional<double> nodata = {};           ///< the value that marks missing data; else that of the file
  double value_scale = 1;                      ///< by which values are multiplied
  bool degrees = false;                        ///< the file is in longitude and latitude
  /// `required`: whether there has to be a file.
  void fields(FieldVisitor& visit, bool required = true);
};

/// Throws OptionError for options that cannot be, whatever the file says.
void check(const RasterOptions& options);

/// What a reader found in a file: the values, NaN where the file itself says that there are none, and where they are.
struct RasterFile {
  /// Column and row, counted from the lower left corner of the file, to a place: (sides of a cell, that corner).
  using Affine = Eigen::Matrix<double, 2, 3>;
  RasterGrid raster;                  ///< values with their georeference
  std::optional<double> nodata = {};  ///< the value that stands for no data
  std::optional<Affine> turned = {};  ///< where the sides are not along the axes; cell and corner then say nothing
};

/// The raster of a file, placed and scaled by the options. Usual fill values that nobody declared, -9999 in many cells
/// say, become "no data", and `note` says so. Throws OptionError, InputError where there are no data.
RasterGrid placed(RasterFile file, const RasterOptions& options, std::string* note = nullptr);

/// Heights that cannot be: a least or greatest value is a fill value that nobody declared if programs use it as one and
/// it is far from the others, or if it is farther from the next one than ten times the width of the raster; and heights
/// of hundreds over cells of a fraction are over degrees. Throws OptionError ("nodata" or "degrees"), unless `nodata`,
/// or `cell`, is given.
void check_heights(const RasterGrid& raster, const RasterOptions& options);

/// Ground that is steeper in the median than any on Earth is in two units: heights in millimetres over cells in metres.
/// Throws OptionError ("value_scale") above a slope of 10, or of 50 where `cell` is given. Level parts do not count,
/// and ground of which they are more than three quarters is taken as it is. Returns a note where most of it is steeper
/// than 60 degrees, as of heights in centimetres; else nothing.
std::string check_slopes(const RasterGrid& raster, const RasterOptions& options);

}  // namespace leastcost
