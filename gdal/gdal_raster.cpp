// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/gdal/gdal_raster.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "gdal/gdal_library.hpp"

namespace leastcost {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  const std::string why = gdal().last_error_message();
  throw InputError(file.string() + ": " + what + (why.empty() ? "" : " (GDAL: " + why + ")"));
}

struct Release {
  void operator()(void* system) const { gdal().destroy_reference(static_cast<OGRSpatialReferenceH>(system)); }
};
using System = std::unique_ptr<void, Release>;

/// Between two systems, x or longitude first. One thread at a time: transformations of OGR share their state.
class PlaceTransform {
 public:
  PlaceTransform(OGRSpatialReferenceH from, OGRSpatialReferenceH to) : it_(gdal().new_transformation(from, to)) {}
  ~PlaceTransform() {
    if (it_ != nullptr) gdal().destroy_transformation(it_);
  }
  PlaceTransform(const PlaceTransform&) = delete;
  PlaceTransform& operator=(const PlaceTransform&) = delete;
  bool known() const { return it_ != nullptr; }

  Eigen::Vector2d operator()(const Eigen::Vector2d& place) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const GdalSilence quiet;
    double x = place[0], y = place[1];
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    if (gdal().transform(it_, 1, &x, &y, nullptr) == 0) return {kNone, kNone};
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

std::string wkt_of(OGRSpatialReferenceH system) {
  constexpr std::array<const char*, 2> kOptions = {"FORMAT=WKT2_2019", nullptr};
  char* text = nullptr;
  const bool known = gdal().export_to_wkt(system, &text, kOptions.data()) == OGRERR_NONE && text != nullptr;
  std::string wkt = known ? text : "";
  gdal().free(text);
  return wkt;
}

/// Null for a system that is neither geographic nor projected: one without a place on the Earth.
std::shared_ptr<const RasterCrs> crs_of(OGRSpatialReferenceH given) {
  if (given == nullptr) return nullptr;
  const System system(gdal().clone_reference(given)), wgs84(gdal().new_reference(nullptr));
  const bool geographic = gdal().is_geographic(system.get()) != 0;
  if (!geographic && gdal().is_projected(system.get()) == 0) return nullptr;
  if (gdal().set_well_known_system(wgs84.get(), "WGS84") != OGRERR_NONE) return nullptr;
  for (const System* one : {&system, &wgs84}) gdal().set_axis_mapping(one->get(), OAMS_TRADITIONAL_GIS_ORDER);
  auto crs = std::make_shared<RasterCrs>();
  const char* name = gdal().reference_name(system.get());
  crs->name = name == nullptr ? "" : name;
  crs->wkt = wkt_of(system.get());
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
  if (gdal().geo_transform(dataset, t.data()) != CE_None) return {};
  if (t[2] != 0 || t[4] != 0) {
    if (const double area = t[1] * t[5] - t[2] * t[4]; area == 0 || !std::isfinite(area))
      fail(file, "the georeference has no valid cells: their area is " + short_number(area, 6));
    const int rows = gdal().raster_y_size(dataset);  // which are stored from the last one of the file on
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
  if (gdal().raster_io(band, GF_Read, 0, line, n, 1, values, n, 1, GDT_Float64, 0, 0) != CE_None ||
      gdal().raster_io(gdal().mask_band(band), GF_Read, 0, line, n, 1, mask.data(), n, 1, GDT_Byte, 0, 0) != CE_None)
    fail(file, "row " + std::to_string(line) + " cannot be read");
  for (int column = 0; column < n; ++column)
    if (mask[static_cast<std::size_t>(column)] == 0) values[column] = std::numeric_limits<double>::quiet_NaN();
}

void load_gdal_for(const std::filesystem::path& file) {
  try {
    static_cast<void>(gdal());
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

}  // namespace

RasterFile read_gdal_raster(const std::filesystem::path& file) {
  load_gdal_for(file);
  static std::once_flag registered;
  std::call_once(registered, gdal().register_all);
  const GdalSilence quiet;
  if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": no such file");
  const GdalDataset dataset(gdal().open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, nullptr, nullptr, nullptr));
  if (!dataset)
    fail(file, "cannot be read as a raster: it must be a GeoTIFF, an ASCII grid (.asc) or of another format of GDAL");
  if (gdal().raster_count(dataset.get()) < 1) fail(file, "the raster has no band");
  RasterFile out;
  RasterGrid& raster = out.raster;
  raster.rows = gdal().raster_y_size(dataset.get());
  raster.columns = gdal().raster_x_size(dataset.get());
  raster.source = file.string();
  raster.crs = crs_of(gdal().spatial_reference(dataset.get()));
  if (raster.rows < 1 || raster.columns < 1 || std::int64_t{raster.rows} * raster.columns > RasterGrid::kMostCells)
    fail(file, "a raster of " + std::to_string(raster.rows) + " x " + std::to_string(raster.columns) +
                   " cells; at least one and at most " + std::to_string(RasterGrid::kMostCells) + " can be read");
  const Placement placement = placement_of(dataset.get(), file);
  out.turned = placement.turned;
  raster.cell << placement.width, placement.height;
  if (placement.given)
    raster.corner << placement.x, placement.upwards ? placement.y : placement.y - raster.rows * placement.height;
  GDALRasterBandH band = gdal().raster_band(dataset.get(), 1);
  raster.values.resize(static_cast<std::size_t>(raster.rows) * static_cast<std::size_t>(raster.columns));
  std::vector<unsigned char> mask(static_cast<std::size_t>(raster.columns));
  for (int line = 0; line < raster.rows; ++line)
    read_row(band, line, raster, placement.upwards ? line : raster.rows - 1 - line, mask, file);
  const double scale = gdal().raster_scale(band, nullptr), offset = gdal().raster_offset(band, nullptr);
  if (scale != 1 || offset != 0)
    for (double& value : raster.values) value = scale * value + offset;
  return out;
}

std::shared_ptr<const RasterCrs> read_gdal_crs(const std::string& text) {
  const GdalSilence quiet;
  const System system(gdal().new_reference(nullptr));
  if (gdal().set_from_user_input(system.get(), text.c_str()) != OGRERR_NONE) return nullptr;
  gdal().morph_from_esri(system.get());
  return crs_of(system.get());
}

std::string gdal_version() { return gdal().version_info("RELEASE_NAME"); }

}  // namespace leastcost
