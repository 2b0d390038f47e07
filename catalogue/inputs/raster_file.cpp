// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/raster_file.hpp"

#include <leastcost/framework/errors.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "problems/readers/file_content.hpp"
#include "problems/readers/raster_reader.hpp"

namespace leastcost {
namespace {

RasterFile read_file(const std::filesystem::path& file) {
  const std::string kind = lower_case(file.extension().string());
  if (kind == ".asc") return read_esri_grid(read_content(file), file.string());
  if (kind == ".csv" || kind == ".txt") return read_csv_raster(read_content(file), file.string());
  if (const RasterReader read = raster_reader_of_libraries()) return read(file);
  throw InputError(file.string() +
                   ": rasters are .asc (ESRI ASCII grid) and .csv files; others, GeoTIFF among them, are read by GDAL, "
                   "which this build does not have: install libgdal-dev and build again, or convert the file with "
                   "gdal_translate -of AAIGrid");
}

}  // namespace

RasterGrid read_raster(const RasterOptions& options, const std::filesystem::path& folder) {
  check(options);
  return placed(read_file(folder / options.file), options);
}

}  // namespace leastcost
