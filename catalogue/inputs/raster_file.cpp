// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/raster_file.hpp"

#include <memory>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "problems/readers/file_content.hpp"
#include "problems/readers/raster_reader.hpp"

namespace leastcost {
namespace {

/// Of the .prj file beside a raster whose format has none; null where there is no such file, or nobody can read it.
std::shared_ptr<const RasterCrs> crs_beside(std::filesystem::path file) {
  file.replace_extension(".prj");
  if (!std::filesystem::is_regular_file(file)) return nullptr;
  const std::string text = read_content(file);
  if (const CrsReader read = crs_reader_of_libraries()) return read(text);
  for (const char* word : {"GEOGCS", "GEOGCRS", "GEODCRS"})
    if (text.rfind(word, 0) == 0) return std::make_shared<const RasterCrs>(RasterCrs{.name = "", .geographic = true});
  return nullptr;
}

RasterFile read_file(const std::filesystem::path& file) {
  const std::string kind = lower_case(file.extension().string());
  if (kind == ".asc") return read_esri_grid(read_content(file), file.string());
  if (kind == ".csv" || kind == ".txt") return read_csv_raster(read_content(file), file.string());
  if (const RasterReader read = raster_reader_of_libraries()) return read(file);
  throw InputError(file.string() +
                   ": without GDAL, this build reads .asc (ESRI ASCII grid) and .csv rasters only; for GeoTIFF and "
                   "others, install libgdal-dev and rebuild, or convert the file with gdal_translate -of AAIGrid");
}

}  // namespace

RasterGrid read_raster(const RasterOptions& options, const std::filesystem::path& folder, Resampling resampling,
                       const std::function<void(std::string)>& note) {
  check(options);
  RasterFile file = read_file(folder / options.file);
  if (!file.raster.crs) file.raster.crs = crs_beside(folder / options.file);
  std::string said;
  RasterGrid raster = placed_upright(std::move(file), options, resampling, said);
  if (note && !said.empty()) note(std::move(said));
  return raster;
}

}  // namespace leastcost
