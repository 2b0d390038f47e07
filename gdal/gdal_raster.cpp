// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/gdal/gdal_raster.hpp>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include <leastcost/framework/errors.hpp>

namespace leastcost {
namespace {

struct Close {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, Close>;

/// GDAL prints its errors unless it is told otherwise, for each thread.
class Quiet {
 public:
  Quiet() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~Quiet() { CPLPopErrorHandler(); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;
};

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  const std::string why = CPLGetLastErrorMsg();
  throw InputError(file.string() + ": " + what + (why.empty() ? "" : " (GDAL: " + why + ")"));
}

/// The corner and the cell of a raster whose first row is the upper one, or the lower one.
struct Placement {
  bool given = false, upwards = false;
  double x = 0, y = 0, width = 1, height = 1;
};

Placement placement_of(GDALDatasetH dataset, const std::filesystem::path& file) {
  std::array<double, 6> t{};  // x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row
  if (GDALGetGeoTransform(dataset, t.data()) != CE_None) return {};
  if (t[2] != 0 || t[4] != 0) fail(file, "the raster is rotated; gdalwarp makes one with sides along the axes");
  if (!(t[1] > 0) || t[5] == 0) fail(file, "the georeference has no cells: their width is " + std::to_string(t[1]));
  return {true, t[5] > 0, t[0], t[3], t[1], std::abs(t[5])};
}

/// A row of the band, upwards, NaN where the mask says that there are no data.
void read_row(GDALRasterBandH band, int line, RasterGrid& raster, int row, std::vector<unsigned char>& mask,
              const std::filesystem::path& file) {
  double* values = &raster.values[raster.index(row, 0)];
  const int n = raster.columns;
  if (GDALRasterIO(band, GF_Read, 0, line, n, 1, values, n, 1, GDT_Float64, 0, 0) != CE_None ||
      GDALRasterIO(GDALGetMaskBand(band), GF_Read, 0, line, n, 1, mask.data(), n, 1, GDT_Byte, 0, 0) != CE_None)
    fail(file, "row " + std::to_string(line) + " cannot be read");
  for (int column = 0; column < n; ++column)
    if (mask[static_cast<std::size_t>(column)] == 0) values[column] = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

RasterFile read_gdal_raster(const std::filesystem::path& file) {
  static std::once_flag registered;
  std::call_once(registered, GDALAllRegister);
  const Quiet quiet;
  if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": there is no such file");
  const Dataset dataset(GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!dataset) fail(file, "cannot be read as a raster");
  if (GDALGetRasterCount(dataset.get()) < 1) fail(file, "the raster has no band");
  RasterFile out;
  RasterGrid& raster = out.raster;
  raster.rows = GDALGetRasterYSize(dataset.get());
  raster.columns = GDALGetRasterXSize(dataset.get());
  raster.source = file.string();
  if (raster.rows < 1 || raster.columns < 1 || std::int64_t{raster.rows} * raster.columns > RasterGrid::kMostCells)
    fail(file, "a raster of " + std::to_string(raster.rows) + " x " + std::to_string(raster.columns) +
                   " cells; at least one and at most " + std::to_string(RasterGrid::kMostCells) + " are read");
  const Placement placement = placement_of(dataset.get(), file);
  raster.cell << placement.width, placement.height;
  if (placement.given)
    raster.corner << placement.x, placement.upwards ? placement.y : placement.y - raster.rows * placement.height;
  GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  raster.values.resize(static_cast<std::size_t>(raster.rows) * static_cast<std::size_t>(raster.columns));
  std::vector<unsigned char> mask(static_cast<std::size_t>(raster.columns));
  for (int line = 0; line < raster.rows; ++line)
    read_row(band, line, raster, placement.upwards ? line : raster.rows - 1 - line, mask, file);
  const double scale = GDALGetRasterScale(band, nullptr), offset = GDALGetRasterOffset(band, nullptr);
  if (scale != 1 || offset != 0)
    for (double& value : raster.values) value = scale * value + offset;
  return out;
}

std::string gdal_version() { return GDALVersionInfo("RELEASE_NAME"); }

}  // namespace leastcost
