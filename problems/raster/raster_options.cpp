// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/raster/raster_options.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/raster/fill_values.hpp"

namespace leastcost {
namespace {

/// Lengths of a degree of longitude and of latitude at a latitude (degrees) on WGS84, m.
Eigen::Vector2d metres_per_degree(double latitude) {
  constexpr double kDegree = std::numbers::pi / 180, kA = 6378137, kF = 1 / 298.257223563, kE2 = kF * (2 - kF);
  const double up = std::sin(latitude * kDegree), root = std::sqrt(1 - kE2 * up * up);
  return kDegree * Eigen::Vector2d(kA / root * std::cos(latitude * kDegree), kA * (1 - kE2) / (root * root * root));
}

/// From longitudes and latitudes to metres east and north of the lower left corner: a plane that touches in the middle.
void from_degrees(RasterGrid& raster) {
  const Eigen::Vector2d middle =
      raster.corner + 0.5 * raster.cell.cwiseProduct(Eigen::Vector2d(raster.columns, raster.rows));
  constexpr double kSteepest = 89;  // where a plane no longer means anything
  if (!(std::abs(middle[1]) <= kSteepest) || !(std::abs(middle[0]) <= 540))
    throw OptionError("degrees", raster.source + ": the centre would be at longitude " + short_number(middle[0], 9) +
                                     " and latitude " + short_number(middle[1], 9));
  const RasterDegrees degrees{raster.corner, metres_per_degree(middle[1])};
  raster.cell = raster.cell.cwiseProduct(degrees.per_degree);
  raster.corner.setZero();
  raster.degrees = degrees;
}

/// Large ones (the least float, mostly) are written with as many digits as a program likes.
bool is_nodata(double value, double nodata) {
  constexpr double kLarge = 1e6, kDigits = 1e-6;
  return std::abs(nodata) < kLarge ? value == nodata : std::abs(value - nodata) <= kDigits * std::abs(nodata);
}

/// With the digits that name it.
std::string digits(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

[[noreturn]] void refuse_fill(const RasterGrid& raster, double value, const RasterOptions& options,
                              const std::string& why) {
  const auto at =
      static_cast<int>(std::find(raster.values.begin(), raster.values.end(), value) - raster.values.begin());
  const std::string raw = digits(value / options.value_scale);
  throw OptionError("nodata", raster.name_of(at / raster.columns, at % raster.columns) + " has the value " + raw +
                                  ", " + why + "; if it marks missing data, set nodata: " + raw);
}

/// No height and no cost is so large; such values are how programs fill cells without data.
void check_magnitude(const RasterGrid& raster, const RasterOptions& options) {
  constexpr double kFill = 1e30;
  for (const double value : raster.values)
    if (std::abs(value) >= kFill) refuse_fill(raster, value, options, "which is too large for a height or a cost");
}

bool may_be_in_degrees(const RasterGrid& raster, const RasterOptions& options) {
  const Eigen::Vector2d upper = raster.place(raster.rows, raster.columns);
  return !raster.degrees && !options.cell && raster.corner[0] >= -180 && upper[0] <= 360 && raster.corner[1] >= -90 &&
         upper[1] <= 90 && raster.cell.maxCoeff() < 0.1;
}

}  // namespace

void check_heights(const RasterGrid& raster, const RasterOptions& options) {
  const RasterExtremes e = extremes_of(raster);
  const double wide = raster.cell.cwiseProduct(Eigen::Vector2d(raster.columns, raster.rows)).norm();
  constexpr double kSteep = 10;  // times as high as wide
  if (may_be_in_degrees(raster, options) && e.second_greatest - e.second_least > kSteep * wide)
    throw OptionError("degrees", raster.source + ": heights differ by " + digits(e.second_greatest - e.second_least) +
                                     " on a raster that is " + digits(wide) +
                                     " across; if its cells are in degrees of longitude and latitude, set degrees: "
                                     "true; if not, give their side lengths (cell)");
  if (options.nodata) return;
  const double range_above = e.greatest - e.second_least, range_below = e.second_greatest - e.least;
  for (const auto& [value, next, range] :
       {std::tuple(e.least, e.second_least, range_above), std::tuple(e.greatest, e.second_greatest, range_below)}) {
    const std::string apart = "a height " + digits(std::abs(value - next)) + " from the next one";
    if (is_usual_fill(value / options.value_scale) && is_far_from_others(value, next, range))
      refuse_fill(raster, value, options, apart + ", as programs write it where there is no height");
    if (std::isfinite(next) && std::abs(value - next) > kSteep * wide)
      refuse_fill(raster, value, options,
                  apart + ", more than " + digits(kSteep) + " times the width of the raster (" + digits(wide) + ")");
  }
}

std::string check_slopes(const RasterGrid& raster, const RasterOptions& options) {
  constexpr double kSteepGround = 10, kSteepOfStatedCells = 50;  // no ground has a median of 5
  constexpr double kSomeSlopes = 0.25;                           // of all: walls on level ground are no slopes
  constexpr double kUnlikely = 1.2;                              // along an axis; the slope itself is 60 degrees then
  if (may_be_in_degrees(raster, options)) return "";             // check_heights() says so
  std::vector<double> slopes;
  slopes.reserve(2 * raster.values.size());

  std::size_t level = 0;
  const auto add = [&](double a, double b, double apart) {
    if (!std::isfinite(a) || !std::isfinite(b)) return;
    if (a == b)
      ++level;
    else
      slopes.push_back(std::abs(b - a) / apart);
  };
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column) {
      const double here = raster.values[raster.index(row, column)];
      if (column + 1 < raster.columns) add(here, raster.values[raster.index(row, column + 1)], raster.cell[0]);
      if (row + 1 < raster.rows) add(here, raster.values[raster.index(row + 1, column)], raster.cell[1]);
    }
  if (slopes.empty() || double(slopes.size()) < kSomeSlopes * double(slopes.size() + level)) return "";
  const auto middle = slopes.begin() + std::ptrdiff_t(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  if (!(*middle > kUnlikely)) return "";
  if (!(*middle > (options.cell ? kSteepOfStatedCells : kSteepGround)))
    return raster.source + ": most of the terrain is steeper than 60 degrees: half of the differences between " +
           "neighbouring heights exceed " + short_number(*middle, 3) + " times the side of a cell. If heights have " +
           "another unit than cells, set value_scale (0.01 if heights are in centimetres, 0.3048 if in feet)";
  throw OptionError("value_scale", raster.source + ": half of the slopes are steeper than " + short_number(*middle, 3) +
                                       " to 1: are heights in metres, as cells are? Set value_scale (0.001 if heights "
                                       "are in millimetres), the side of a cell (cell), or degrees: true if cells are "
                                       "in degrees");
}

std::string RasterGrid::name_of(int row, int column) const {
  return "row " + std::to_string(rows - 1 - row) + ", column " + std::to_string(column) + " of " + source;
}

void RasterOptions::fields(FieldVisitor& visit, bool required) {
  visit.file("file", file,
             {.help = "Raster: an ESRI ASCII grid (.asc), a table of numbers whose first line is the northernmost row "
                      "(.csv), or, in builds with GDAL, any raster that GDAL reads (.tif).",
              .required = required});
  visit.field(
      "cell", cell,
      {.help = "Side length of a cell, [25], or lengths along x and y, [25, 30]; default: from the file, or [1].",
       .unit = "length",
       .minimum = 0,
       .exclusive_minimum = true});
  visit.field("origin", origin,
              {.help = "Position (x, y) of the lower left corner of the raster; default: from the file, or (0, 0).",
               .unit = "length"});
  visit.field("nodata", nodata, {.help = "Value that marks missing data; default: from the file."});
  visit.field("value_scale", value_scale,
              {.help = "Factor by which values are multiplied: 0.3048 converts feet to metres."});
  visit.field("degrees", degrees,
              {.help = "Whether cell and origin, from the file or given here, are longitude and latitude in degrees. "
                       "Points are then metres east and north of the lower left corner, on WGS84, exact at the "
                       "raster's centre. Not needed if the CRS of the file, or the .prj beside it, says so."});
}

void check(const RasterOptions& o) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (o.cell && (o.cell->size() < 1 || o.cell->size() > 2 || !std::all_of(o.cell->begin(), o.cell->end(), positive)))
    throw OptionError("cell", "must be one or two lengths greater than 0");
  if (o.origin && (o.origin->size() != 2 || !o.origin->allFinite()))
    throw OptionError("origin", "must have two finite numbers, x and y");
  if (!std::isfinite(o.value_scale) || o.value_scale == 0)
    throw OptionError("value_scale", "must be a finite number other than 0");
}

RasterGrid placed(RasterFile file, const RasterOptions& options, std::string* note) {
  check(options);
  RasterGrid raster = std::move(file.raster);
  if (options.cell) raster.cell = {(*options.cell)[0], (*options.cell)[options.cell->size() - 1]};
  if (options.origin) raster.corner = *options.origin;
  const std::optional<double> nodata = options.nodata ? options.nodata : file.nodata;
  for (double& value : raster.values)
    if ((nodata && is_nodata(value, *nodata)) || !std::isfinite(value))
      value = std::numeric_limits<double>::quiet_NaN();
  if (!options.nodata) {
    const std::string fill = take_fill_values(raster);
    if (note != nullptr && !fill.empty()) *note = fill;
  }
  bool any = false;
  for (double& value : raster.values) {
    value *= options.value_scale;
    any = any || std::isfinite(value);
  }
  check_magnitude(raster, options);
  if (!any) throw InputError(raster.source + ": no cell of the raster has data");
  if (!raster.place(raster.rows, raster.columns).allFinite())
    throw InputError(raster.source + ": the extent of the raster overflows");
  if (options.cell && options.origin) raster.crs.reset();  // what the file says of its place is replaced
  if (options.degrees || (raster.crs && raster.crs->geographic)) from_degrees(raster);
  return raster;
}

}  // namespace leastcost
