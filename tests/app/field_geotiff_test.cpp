// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// `leastcost field -o cost.tif`, as gdalinfo, gdallocationinfo and our own reader see it.
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "catalogue/inputs/raster_file.hpp"
#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/shell.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

/// Costs of the hills of configs/data with a CRS and a corner, and what gdalinfo says of the field over them.
struct OnHills {
  ScratchDir dir;
  std::vector<double> values;
  Json info;

  OnHills(const std::string& placement, const std::string& from, const std::string& options = "") {
    const fs::path asc = project_dir() / "configs/data/hills.asc";
    REQUIRE(output_of("gdal_translate -ot Float64 " + placement + " '" + asc.string() + "' '" +
                      (dir / "hills.tif").string() + "'") != "");
    const std::string config =
        text_file(dir / "c.yaml", "manifold: {type: euclidean, dimension: 2}\ncost: {type: cost_map, file: hills.tif" +
                                      options + "}\n");
    for (const char* file : {"f.tif", "f.npy"}) {
      const Called called = call({"field", config, "-o", (dir / file).string(), "--from", from});
      CAPTURE(called.err);
      REQUIRE(called.exit == 0);
    }
    values = npy_numbers(dir / "f.npy");
    info = Json::parse(output_of("gdalinfo -json '" + (dir / "f.tif").string() + "'"));
  }

  /// As GDAL reads the pixel in a column and a line from the top.
  double pixel(int column, int line) const {
    const std::string text = output_of("gdallocationinfo -valonly '" + (dir / "f.tif").string() + "' " +
                                       std::to_string(column) + " " + std::to_string(line));
    return text.rfind("nan", 0) == 0 ? std::nan("") : std::stod(text);
  }
};

bool has_gdal() { return has_program("gdal_translate", "gdal-bin") && has_program("gdalinfo", "gdal-bin"); }

}  // namespace

TEST_CASE("field as GeoTIFF: pixels and transform and CRS of a raster in UTM are those that the configuration reads") {
  if (!has_gdal()) return;
  const OnHills field("-a_srs EPSG:32632 -a_ullr 499000 5206000 501000 5204000", "500000,5205000");
  const Json source = Json::parse(output_of("gdalinfo -json '" + (field.dir / "hills.tif").string() + "'"));
  CHECK(field.info["driverShortName"] == "GTiff");
  CHECK(field.info["bands"][0]["type"] == "Float64");
  CHECK(field.info["bands"][0]["description"] == "cost");
  CHECK(field.info["bands"][0]["noDataValue"] == "NaN");
  CHECK(field.info["coordinateSystem"]["wkt"] == source["coordinateSystem"]["wkt"]);
  CHECK_THAT(field.info["coordinateSystem"]["wkt"].get<std::string>(), Contains("32632"));
  CHECK(field.info["size"] == source["size"]);  // a node on every value
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(field.info["geoTransform"][k].get<double>() ==
          Approx(source["geoTransform"][k].get<double>()).epsilon(1e-12).margin(1e-9));
  const int columns = field.info["size"][0], lines = field.info["size"][1];
  REQUIRE(field.values.size() == static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines));
  RasterOptions options;
  options.file = "f.tif";
  const RasterGrid read = read_raster(options, field.dir.path());
  int missing = 0, wrong = 0;
  for (int line = 0; line < lines; ++line)
    for (int column = 0; column < columns; ++column) {
      const double value = field.values[static_cast<std::size_t>(line * columns + column)],
                   other = read.value(lines - 1 - line, column);
      if (std::isnan(value)) ++missing;
      if (std::isnan(value) ? !std::isnan(other) : value != other) ++wrong;
    }
  CHECK(missing > 0);
  CHECK(wrong == 0);
  for (const auto& [column, line] : {std::pair{0, 0}, std::pair{columns - 1, 2}, std::pair{columns / 2, lines / 2}}) {
    const double value = field.values[static_cast<std::size_t>(line * columns + column)],
                 other = field.pixel(column, line);
    CHECK((std::isnan(value) ? std::isnan(other) : other == Approx(value).epsilon(1e-12)));
  }
}

TEST_CASE("field as GeoTIFF: of a raster in degrees it is in degrees again, as far off as rounding") {
  if (!has_gdal()) return;
  const OnHills field("-a_srs EPSG:4326 -a_ullr 8 47.1 8.2 47", "1520,5560");
  const Json source = Json::parse(output_of("gdalinfo -json '" + (field.dir / "hills.tif").string() + "'"));
  CHECK(field.info["coordinateSystem"]["wkt"] == source["coordinateSystem"]["wkt"]);
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(field.info["geoTransform"][k].get<double>() ==
          Approx(source["geoTransform"][k].get<double>()).epsilon(1e-12).margin(1e-12));
}

TEST_CASE("field as GeoTIFF: nodes lie in the middles of cells, and there is no CRS where none is known") {
  if (!has_gdal()) return;
  const ScratchDir dir;
  const std::string config =
      text_file(dir / "box.yaml", "manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}\ncost: euclidean\n");
  const std::string tif = (dir / "f.TIF").string();
  REQUIRE(call({"field", config, "-o", tif, "--from", "1,1", "--resolution", "0.5"}).exit == 0);
  const Json info = Json::parse(output_of("gdalinfo -json '" + tif + "'"));
  CHECK(info["geoTransform"] == Json::parse("[-0.25, 0.5, 0.0, 2.25, 0.0, -0.5]"));
  CHECK(info["size"] == Json::parse("[9, 5]"));
  CHECK_FALSE(info.contains("coordinateSystem"));
  // The pixel at the place (1, 1), and that at (0, 1).
  CHECK(std::stod(output_of("gdallocationinfo -valonly -geoloc '" + tif + "' 1 1")) == 0);
  CHECK(std::stod(output_of("gdallocationinfo -valonly -geoloc '" + tif + "' 0 1")) == Approx(1).epsilon(1e-9));
  text_file(dir / "fold.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string mesh = text_file(dir / "mesh.yaml", "manifold: {type: mesh, file: fold.obj}\ncost: euclidean\n");
  CHECK_THAT(call({"field", mesh, "-o", tif, "--from", "0"}).err,
             Contains("can be written as .csv, .npy, .vtp or .ply"));
}

}  // namespace leastcost::test
