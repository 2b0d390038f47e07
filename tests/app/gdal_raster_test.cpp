// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Rasters by GDAL, against the same raster read by our own readers.
#include <leastcost/gdal/gdal_raster.hpp>

#include <fstream>

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/catalogue/run/run.hpp>
#include <leastcost/framework/errors.hpp>
#include "catalogue/inputs/raster_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/shell.hpp"

namespace leastcost::test {

TEST_CASE("GeoTIFF: values, georeference and missing data are those of the same ESRI grid") {
  if (!has_program("gdal_translate", "gdal-bin")) return;
  const ScratchDir dir;
  const std::filesystem::path asc = project_dir() / "configs/data/hills.asc";
  REQUIRE(output_of("gdal_translate -ot Float64 '" + asc.string() + "' '" + (dir / "hills.tif").string() + "'") != "");
  RasterOptions options;
  options.file = "hills.tif";
  const RasterGrid tiff = read_raster(options, dir.path());
  options.file = asc.string();
  const RasterGrid grid = read_raster(options, "");
  CHECK(tiff.rows == grid.rows);
  CHECK(tiff.columns == grid.columns);
  CHECK(tiff.cell == grid.cell);
  CHECK(tiff.corner == grid.corner);
  REQUIRE(tiff.values.size() == grid.values.size());
  long missing = 0;
  for (std::size_t i = 0; i < grid.values.size(); ++i) {
    if (std::isnan(grid.values[i])) {
      ++missing;
      CHECK(std::isnan(tiff.values[i]));
    } else {
      CHECK(tiff.values[i] == Approx(grid.values[i]).epsilon(1e-6));  // GDAL reads the text as float
    }
  }
  CHECK(missing > 0);
  CHECK(!gdal_version().empty());
}

TEST_CASE(
    "GeoTIFF: its CRS is read, geographic means degrees, projected places are on the Earth, rotation is refused") {
  if (!has_program("gdal_translate", "gdal-bin")) return;
  const ScratchDir dir;
  const std::string asc = "'" + (project_dir() / "configs/data/hills.asc").string() + "' ";
  const auto made = [&](const std::string& how, const char* name) {
    REQUIRE(output_of("gdal_translate " + how + " " + asc + "'" + (dir / name).string() + "'") != "");
    RasterOptions options;
    options.file = name;
    return read_raster(options, dir.path());
  };
  const RasterGrid degrees = made("-a_srs EPSG:4326 -a_ullr 8 47.1 8.2 47", "degrees.tif");
  REQUIRE(degrees.degrees);
  CHECK(degrees.cell[0] * degrees.columns == Approx(0.2 * 76000).epsilon(0.01));  // a degree of longitude at 47 north
  CHECK((degrees.longitude_latitude(degrees.place_of({8.1, 47.05})) - Eigen::Vector2d(8.1, 47.05)).norm() < 1e-9);
  CHECK_THAT(degrees.place_note(), Catch::Contains("WGS 84"));

  // UTM zone 32: on its central meridian the easting is 500000, the latitude 47 at the northing 5205288.7 (0.9996 k).
  const RasterGrid utm = made("-a_srs EPSG:32632 -a_ullr 499000 5206000 501000 5204000", "utm.tif");
  CHECK_FALSE(utm.degrees);
  REQUIRE(utm.on_earth());
  const Eigen::Vector2d place = utm.place_of({9, 47});
  CHECK(place[0] == Approx(500000).epsilon(1e-9));
  CHECK((utm.longitude_latitude(place) - Eigen::Vector2d(9, 47)).norm() < 1e-9);

  REQUIRE(output_of("gdal_translate -of VRT " + asc + "'" + (dir / "turned.vrt").string() + "'") != "");
  std::ifstream in(dir / "turned.vrt");
  std::string text(std::istreambuf_iterator<char>(in), {});
  const std::size_t at = text.find("<GeoTransform>") + 14;
  text.replace(at, text.find('<', at) - at, "0, 10, 5, 100, 5, -10");
  std::ofstream(dir / "turned.vrt") << text;
  CHECK_THROWS_WITH(read_gdal_raster(dir / "turned.vrt"), Catch::Contains("gdalwarp -r bilinear"));
}

TEST_CASE("GeoPackage: the path and its points over a raster with a CRS open in ogrinfo as layers in WGS84") {
  if (!has_program("gdal_translate", "gdal-bin") || !has_program("ogrinfo", "gdal-bin")) return;
  const ScratchDir dir;
  REQUIRE(output_of("gdal_translate -a_srs EPSG:32632 -a_ullr 500000 5201000 501000 5200000 '" +
                    (project_dir() / "configs/data/hills.asc").string() + "' '" + (dir / "utm.tif").string() + "'") !=
          "");
  const auto run_in = [&](const std::string& files) {
    write_run(solve(parse_run("manifold: {type: terrain, file: utm.tif}\ncost: euclidean\nends: {source: {point: "
                              "[500100, 5200200]}, target: {point: [500300, 5200400]}}\npath: {points: 9}\n"
                              "certificate: {enabled: false}\noutput: {files: [" +
                                  files + "]}\n",
                              "a.yaml", dir.path())),
              dir / "out", {.replace = true});
  };
  run_in("result, gpkg");
  const std::string file = "'" + (dir / "out/path.gpkg").string() + "'";
  const std::string line = output_of("ogrinfo -so " + file + " path 2>&1");
  CHECK_THAT(line,
             Catch::Contains("Feature Count: 1") && Catch::Contains("\"EPSG\",4326") && Catch::Contains("cost: Real"));
  CHECK_THAT(output_of("ogrinfo -so " + file + " points 2>&1"), Catch::Contains("Feature Count: 11"));
  run_in("result");
  CHECK_FALSE(std::filesystem::exists(dir / "out/path.gpkg"));
}

TEST_CASE("GDAL: what it cannot read is an error with the name of the file") {
  const ScratchDir dir;
  std::ofstream(dir / "a.tif") << "no raster";
  CHECK_THROWS_WITH(read_gdal_raster(dir / "a.tif"), Catch::Contains("a.tif: cannot be read as a raster"));
  CHECK_THROWS_WITH(read_gdal_raster(dir / "b.tif"), Catch::Contains("b.tif: there is no such file"));
}

TEST_CASE("GDAL: a TIFF of the data set without georeference is placed by options") {
  const auto tiff = data_file("rasters/volcano.tif"), csv = data_file("rasters/volcano.csv");
  if (!tiff || !csv) return;
  RasterOptions options;
  options.cell = Eigen::VectorXd::Constant(1, 10);
  options.file = tiff->string();
  const RasterGrid a = read_raster(options, "");
  options.file = csv->string();
  const RasterGrid b = read_raster(options, "");
  CHECK(a.values == b.values);
  CHECK(a.cell == Eigen::Vector2d(10, 10));
}

}  // namespace leastcost::test
