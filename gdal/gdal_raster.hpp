// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <leastcost/problems/raster/raster_options.hpp>

namespace leastcost {

/// The first band of a raster file in a format that GDAL knows (GeoTIFF, ERDAS, HGT, ...), with its scale and offset,
/// its georeference, its CRS with the ways to WGS84 and back, and NaN where its mask says that there are no data.
/// A rotated raster comes as it is, with RasterFile::turned. Throws InputError for a file that GDAL cannot read, and
/// for a raster that is larger than RasterGrid::kMostCells.
RasterFile read_gdal_raster(const std::filesystem::path& file);

/// The CRS that a text names: WKT of either kind (.prj files), PROJ, "EPSG:2056"; null where GDAL knows none.
std::shared_ptr<const RasterCrs> read_gdal_crs(const std::string& text);

/// "3.6.2".
std::string gdal_version();

}  // namespace leastcost
