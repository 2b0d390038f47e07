// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/problems/raster/raster.hpp>

namespace leastcost {

/// The bytes of a GeoTIFF with one band of doubles: the values of a raster in the middles of its cells, the
/// northernmost row first, NaN for no data, with its CRS where that is known. A raster that was read in degrees, and
/// placed in metres, is in degrees again. `what`, `unit`: of the values. Throws InputError where GDAL refuses.
std::string gdal_geotiff(const RasterGrid& raster, const std::string& what, const std::string& unit);

}  // namespace leastcost
