// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/gdal/gdal_raster.hpp>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"

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

struct Release {
  void operator()(void* system) const { OSRDestroySpatialReference(static_cast<OGRSpatialReferenceH>(system)); }
};
using System = std::unique_ptr<void, Release>;

/// Between two systems, x or longitude first. One thread at a time: transformations of OGR share their state.
class PlaceTransform {
 public:
  PlaceTransform(OGRSpatialReferenceH from, OGRSpatialReferenceH to) : it_(OCTNewCoordinateTransformation(from, to)) {}
  ~PlaceTransform() {
    if (it_ != nullptr) OCTDestroyCoordinateTransformation(it_);
  }
  PlaceTransform(const PlaceTransform&) = delete;
  PlaceTransform& operator=(const PlaceTransform&) = delete;
  bool known() const { return it_ != nullptr; }

  Eigen::Vector2d operator()(const Eigen::Vector2d& place) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Quiet quiet;
    double x = place[0], y = place[1];
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (OCTTransform(it_, 1, &x, &y, nullptr) == 0) return {kNone, kNone};
    return {x, y};
  }

 private:
  OGRCoordinateTransformationH it_;
  mutable std::mutex mutex_;
};

RasterCrs::Transform transform(OGRSpatialReferenceH from, OGRSpatialReferenceH to) {
  auto made = std::make_shared<const PlaceTransform>(from, to);
  if (!made->known()) return {};
  return [made = std::move(made)](const Eigen::Vector2d& place) { return (*made)(place); };
}

/// Null for a system that is neither geographic nor projected: one without a place on the Earth.
std::shared_ptr<const RasterCrs> crs_of(OGRSpatialReferenceH given) {
  if (given == nullptr) return nullptr;
  const System system(OSRClone(given)), wgs84(OSRNewSpatialReference(nullptr));
  const bool geographic = OSRIsGeographic(system.get()) != 0;
  if (!geographic && OSRIsProjected(system.get()) == 0) return nullptr;
  if (OSRSetWellKnownGeogCS(wgs84.get(), "WGS84") != OGRERR_NONE) return nullptr;
  for (const System* one : {&system, &wgs84}) OSRSetAxisMappingStrategy(one->get(), OAMS_TRADITIONAL_GIS_ORDER);
  auto crs = std::make_shared<RasterCrs>();
  const char* name = OSRGetName(system.get());
  crs->name = name == nullptr ? "" : name;
  crs->geographic = geographic;
  crs->to_wgs84 = transform(system.get(), wgs84.get());
  crs->from_wgs84 = transform(wgs84.get(), system.get());
  return crs;
}

/// The corner and the cell of a raster whose first row is the upper one, or the lower one; or how it is turned.
struct Placement {
  bool given = false, upwards = false;
  double x = 0, y = 0, width = 1, height = 1;
  std::optional<RasterFile::Affine> turned = {};
};

Placement placement_of(GDALDatasetH dataset, const std::filesystem::path& file) {
  std::array<double, 6> t{};  // x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row
  if (GDALGetGeoTransform(dataset, t.data()) != CE_None) return {};
  if (t[2] != 0 || t[4] != 0) {
    if (const double area = t[1] * t[5] - t[2] * t[4]; area == 0 || !std::isfinite(area))
      fail(file, "the georeference has no valid cells: their area is " + short_number(area, 6));
    const int rows = GDALGetRasterYSize(dataset);  // which are stored from the last one of the file on
    Placement askew;
    askew.turned.emplace();
    *askew.turned << t[1], -t[2], t[0] + rows * t[2], t[4], -t[5], t[3] + rows * t[5];
    return askew;
  }
  if (!(t[1] > 0) || t[5] == 0)
    fail(file, "the georeference has no valid cells: their width is " + short_number(t[1], 6));
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
  if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": no such file");
  const Dataset dataset(GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!dataset) fail(file, "cannot be read as a raster");
  if (GDALGetRasterCount(dataset.get()) < 1) fail(file, "the raster has no band");
  RasterFile out;
  RasterGrid& raster = out.raster;
  raster.rows = GDALGetRasterYSize(dataset.get());
  raster.columns = GDALGetRasterXSize(dataset.get());
  raster.source = file.string();
  raster.crs = crs_of(GDALGetSpatialRef(dataset.get()));
  if (raster.rows < 1 || raster.columns < 1 || std::int64_t{raster.rows} * raster.columns > RasterGrid::kMostCells)
    fail(file, "a raster of " + std::to_string(raster.rows) + " x " + std::to_string(raster.columns) +
                   " cells; at least one and at most " + std::to_string(RasterGrid::kMostCells) + " can be read");
  const Placement placement = placement_of(dataset.get(), file);
  out.turned = placement.turned;
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

std::shared_ptr<const RasterCrs> read_gdal_crs(const std::string& text) {
  const Quiet quiet;
  const System system(OSRNewSpatialReference(nullptr));
  if (OSRSetFromUserInput(system.get(), text.c_str()) != OGRERR_NONE) return nullptr;
  OSRMorphFromESRI(system.get());
  return crs_of(system.get());
}

std::string gdal_version() { return GDALVersionInfo("RELEASE_NAME"); }

}  // namespace leastcost
