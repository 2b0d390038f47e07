// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// Whether programs write this number where they have no value: -9999, -32768, 1e38, ...
bool is_usual_fill(double value);

/// Whether a value, the least or the greatest of a raster, is far from the others: from the next one by half of their
/// range or more.
bool is_far_from_others(double value, double next, double range_of_others);

/// The least and the greatest value, and those next to them; infinite where there are none.
struct RasterExtremes {
  double least, greatest, second_least, second_greatest;
};
RasterExtremes extremes_of(const RasterGrid& raster);

/// Replaces the usual fill values by NaN where nobody declared them: numbers below 0 or of 1e30 and more that fill two
/// cells or more and are far from all others, or the only ones below 0. Returns a note that says which and how to say
/// otherwise; empty where there are none. Values as they are in the file.
std::string take_fill_values(RasterGrid& raster);

}  // namespace leastcost
