// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/gdal/gdal_geotiff.hpp>

#include <array>
#include <limits>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "gdal/gdal_library.hpp"
#include "gdal/memory_file.hpp"

namespace leastcost {
namespace {

void must(bool done) {
  if (!done) throw InputError(std::string("GeoTIFF: cannot be written (GDAL: ") + gdal().last_error_message() + ")");
}

/// From column and line, the first line the upper one, to the places of the file.
std::array<double, 6> transform_of(const RasterGrid& raster) {
  Eigen::Vector2d corner = raster.corner, cell = raster.cell;
  if (const auto& degrees = raster.degrees) {
    corner = degrees->corner + corner.cwiseQuotient(degrees->per_degree);
    cell = cell.cwiseQuotient(degrees->per_degree);
  }
  return {corner[0], cell[0], 0, corner[1] + raster.rows * cell[1], 0, -cell[1]};
}

void set_crs(GDALDatasetH dataset, const RasterGrid& raster) {
  if (!raster.crs || raster.crs->wkt.empty()) return;
  const OGRSpatialReferenceH system = gdal().new_reference(raster.crs->wkt.c_str());
  if (system == nullptr) return;
  gdal().set_axis_mapping(system, OAMS_TRADITIONAL_GIS_ORDER);
  gdal().set_spatial_reference(dataset, system);
  gdal().destroy_reference(system);
}

void write_lines(GDALRasterBandH band, const RasterGrid& raster) {
  std::vector<double> line(static_cast<std::size_t>(raster.columns));
  for (int row = raster.rows - 1; row >= 0; --row) {
    for (int column = 0; column < raster.columns; ++column)
      line[static_cast<std::size_t>(column)] = raster.value(row, column);
    must(gdal().raster_io(band, GF_Write, 0, raster.rows - 1 - row, raster.columns, 1, line.data(), raster.columns, 1,
                          GDT_Float64, 0, 0) == CE_None);
  }
}

}  // namespace

std::string gdal_geotiff(const RasterGrid& raster, const std::string& what, const std::string& unit) {
  gdal().register_all();
  const GdalSilence silence;
  GDALDriverH driver = gdal().driver_by_name("GTiff");
  must(driver != nullptr);
  const GdalMemoryFile file(".tif");
  std::string large = "BIGTIFF=IF_SAFER";
  std::array<char*, 2> options = {large.data(), nullptr};
  GdalDataset made(gdal().create(driver, file.name(), raster.columns, raster.rows, 1, GDT_Float64, options.data()));
  must(made != nullptr);
  std::array<double, 6> transform = transform_of(raster);
  must(gdal().set_geo_transform(made.get(), transform.data()) == CE_None);
  set_crs(made.get(), raster);
  GDALRasterBandH band = gdal().raster_band(made.get(), 1);
  must(gdal().set_no_data_value(band, std::numeric_limits<double>::quiet_NaN()) == CE_None);
  gdal().set_description(band, what.c_str());
  gdal().set_unit(band, unit.c_str());
  write_lines(band, raster);
  made.reset();  // writes what is left
  return file.bytes();
}

}  // namespace leastcost
