// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <leastcost/problems/raster/raster_options.hpp>

namespace leastcost {

/// The first band of a raster file in a format that GDAL knows (GeoTIFF, ERDAS, HGT, ...), with its scale and offset,
/// its georeference, and NaN where its mask says that there are no data. Throws InputError for a file that GDAL cannot
/// read, for a raster that is rotated, and for one that is larger than RasterGrid::kMostCells.
RasterFile read_gdal_raster(const std::filesystem::path& file);

/// "3.6.2".
std::string gdal_version();

}  // namespace leastcost
