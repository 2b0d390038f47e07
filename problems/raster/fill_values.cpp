// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/fill_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "framework/base/point_text.hpp"

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTooLarge = 1e30;  ///< for a height or a cost

/// Of floats and of whole numbers with so many bits, and nines.
constexpr std::array kUsual = {-99.0,    -999.0,       -9999.0,       -99999.0,     -999999.0, -32767.0,
                               -32768.0, -2147483647., -2147483648.0, 9999.0,       99999.0,   999999.0,
                               32767.0,  65535.0,      2147483647.0,  4294967295.0, 1e20,      -1e20};

/// Replaces the values that `is_fill` and says so; empty where fewer than two cells have one.
template <class IsFill>
std::string take(RasterGrid& raster, const IsFill& is_fill, const char* which) {
  std::size_t cells = 0, first = 0;
  for (std::size_t top_down = 0; top_down < raster.values.size(); ++top_down) {
    const auto columns = static_cast<std::size_t>(raster.columns);
    const std::size_t i = raster.values.size() - columns * (top_down / columns + 1) + top_down % columns;
    if (is_fill(raster.values[i]) && cells++ == 0) first = i;
  }
  if (cells < 2) return "";
  const double value = raster.values[first];
  for (double& v : raster.values)
    if (is_fill(v)) v = std::numeric_limits<double>::quiet_NaN();
  return "the value " + short_number(value, 10) + " was taken as \"no data\": " + std::to_string(cells) + " of " +
         std::to_string(raster.values.size()) + " cells have it, the first is " +
         raster.name_of(static_cast<int>(first) / raster.columns, static_cast<int>(first) % raster.columns) +
         ", and it is far " + which + " all others. If it is a value, set nodata to a number that no cell has, like " +
         "nodata: 12345.6";
}

}  // namespace

bool is_usual_fill(double value) {
  constexpr double kRounding = 1e-9;
  return std::abs(value) >= kTooLarge || std::any_of(kUsual.begin(), kUsual.end(), [value](double usual) {
           return std::abs(value - usual) <= kRounding * std::abs(usual);
         });
}

bool is_far_from_others(double value, double next, double range_of_others) {
  constexpr double kFar = 0.5;
  const double gap = std::abs(value - next);
  return std::isfinite(gap) && gap >= kFar * range_of_others;
}

RasterExtremes extremes_of(const RasterGrid& raster) {
  RasterExtremes e{kInfinity, -kInfinity, kInfinity, -kInfinity};
  for (const double value : raster.values) {
    if (std::isnan(value)) continue;
    if (value < e.least) {
      e.second_least = e.least;
      e.least = value;
    } else if (value > e.least && value < e.second_least) {
      e.second_least = value;
    }
    if (value > e.greatest) {
      e.second_greatest = e.greatest;
      e.greatest = value;
    } else if (value < e.greatest && value > e.second_greatest) {
      e.second_greatest = value;
    }
  }
  return e;
}

std::string take_fill_values(RasterGrid& raster) {
  constexpr int kMostFills = 4;
  std::string said;
  const auto add = [&said](const std::string& more) {
    if (!more.empty()) said += (said.empty() ? "" : "; ") + more;
    return !more.empty();
  };
  // As many digits as a program likes: a float or its shortest text.
  add(take(
      raster, [](double v) { return v <= -kTooLarge; }, "below"));
  add(take(
      raster, [](double v) { return v >= kTooLarge; }, "above"));
  for (int k = 0; k < kMostFills; ++k) {
    const RasterExtremes e = extremes_of(raster);
    const double fill = e.least;  // a cost of 9999 is a dear cell, a cost below 0 is none
    // -99 is not far below heights up to 300; but where no other value is below 0, it is none either.
    const bool far = is_far_from_others(fill, e.second_least, e.greatest - e.second_least) || e.second_least >= 0;
    if (!(fill < 0) || !is_usual_fill(fill) || !far) break;
    if (!add(take(
            raster, [fill](double v) { return v == fill; }, "below")))
      break;
  }
  return said;
}

}  // namespace leastcost
