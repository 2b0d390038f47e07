// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Rasters by GDAL, against the same raster read by our own readers.
#include <leastcost/gdal/gdal_raster.hpp>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>
#include <leastcost/framework/base/errors.hpp>
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

TEST_CASE("GeoTIFF: its CRS is read, geographic means degrees, projected places are on the Earth") {
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
}

namespace {

std::string ends_at(const char* how, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return fmt::format("ends: {{source: {{{0}: [{1:.15g}, {2:.15g}]}}, target: {{{0}: [{3:.15g}, {4:.15g}]}}}}\n", how,
                     a[0], a[1], b[0], b[1]);
}

}  // namespace

TEST_CASE("GDAL is loaded for the first raster that needs it, and an error says what to install where it is missing") {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "leastcost";  // beside the tests
  if (!std::filesystem::exists(program)) return record_skip("loading of GDAL", "the program was not built");
  const ScratchDir dir;
  std::ofstream(dir / "dem.tif") << "II*";
  std::ofstream(dir / "libgdal.so.32") << "";  // found first, and no library
  std::ofstream(dir / "a.yaml") << "manifold: {type: terrain, file: dem.tif}\ncost: {type: euclidean}\n"
                                << ends_at("point", {0, 0}, {1, 1});
  const std::string run = "cd '" + dir.path().string() + "' && LD_LIBRARY_PATH=. '" + program.string() + "' ";
  CHECK_THAT(output_of(run + "--version"), Catch::Contains("leastcost"));
  CHECK_THAT(output_of(run + "run a.yaml 2>&1 || true"),
             Catch::Contains("libgdal.so.32 cannot be loaded: install") && Catch::Contains("dem.tif"));
}

namespace {

/// 40 x 30 cells of 3 x 2 (along the turned sides), turned by 30 degrees, lines downwards; places are begin + side *
/// (x, y) of indices, z is 0.3 x + 0.2 y + 100 and the cost 1 + 0.01 x.
struct Turned {
  static constexpr int kColumns = 40, kLines = 30;
  Eigen::Vector2d begin;
  double side;

  Eigen::Vector2d offset(double column, double line) const {
    const double c = std::sqrt(0.75), s = 0.5;
    return {3 * c * column + 2 * s * line, 3 * s * column - 2 * c * line};
  }
  Eigen::Vector2d place(double column, double line) const { return begin + side * offset(column, line); }
  static double height(const Eigen::Vector2d& at) { return 0.3 * at[0] + 0.2 * at[1] + 100; }
  static double unit_cost(const Eigen::Vector2d& at) { return 1 + 0.01 * at[0]; }

  template <class F>
  void write(const ScratchDir& dir, const std::string& name, const std::string& crs, F value) const {
    std::ofstream asc(dir / (name + ".asc"));
    asc.precision(12);
    asc << "ncols " << kColumns << "\nnrows " << kLines << "\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
    for (int line = 0; line < kLines; ++line)
      for (int column = 0; column < kColumns; ++column)
        asc << value(offset(column + 0.5, line + 0.5)) << (column + 1 < kColumns ? ' ' : '\n');
    asc.close();
    const std::filesystem::path vrt = dir / (name + ".vrt");
    REQUIRE(output_of("gdal_translate -ot Float64 -of VRT -a_srs " + crs + " '" + (dir / (name + ".asc")).string() +
                      "' '" + vrt.string() + "'") != "");
    std::ifstream in(vrt);
    std::string text(std::istreambuf_iterator<char>(in), {});
    in.close();
    const Eigen::Vector2d x = side * offset(1, 0), y = side * offset(0, 1);
    const std::size_t at = text.find("<GeoTransform>") + 14;
    text.replace(at, text.find('<', at) - at,
                 fmt::format("{:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g}", begin[0], x[0], y[0], begin[1],
                             x[1], y[1]));
    std::ofstream(vrt) << text;
  }
};

RunOutcome solved(const std::string& text, const ScratchDir& dir) {
  return solve(parse_run(text + "path: {points: 9}\n", "a.yaml", dir.path()));
}

long notes_of_turning(const RunOutcome& run) {
  return std::count_if(run.parts.notes.begin(), run.parts.notes.end(), [](const std::string& note) {
    return note.find("is rotated by 30 degrees") != std::string::npos;
  });
}

}  // namespace

TEST_CASE(
    "GeoTIFF: of a rotated raster, lengths and costs are those of the ground, and a note says that it is turned") {
  if (!has_program("gdal_translate", "gdal-bin")) return;
  const ScratchDir dir;
  const Turned utm{{500000, 5205000}, 1}, degrees{{9, 47}, 1e-5};
  utm.write(dir, "utm", "EPSG:32632", Turned::height);
  utm.write(dir, "cost", "EPSG:32632", Turned::unit_cost);
  degrees.write(dir, "degrees", "EPSG:4326", Turned::height);
  const Eigen::Vector2d a = utm.offset(8, 20), b = utm.offset(30, 8);
  const double up = Turned::height(b) - Turned::height(a);
  const std::string terrain = "cost: euclidean\nmanifold: {type: terrain, file: ";

  const std::string in_crs = ends_at("point", utm.place(8, 20), utm.place(30, 8));
  const RunOutcome hill = solved(terrain + "utm.vrt}\n" + in_crs, dir);
  CHECK(hill.result.status == Status::certified);
  CHECK(hill.result.curve.cost == Approx(std::hypot((b - a).norm(), up)).epsilon(1e-6));
  CHECK(notes_of_turning(hill) == 1);

  // A degree of longitude and one of latitude at 47.00004 degrees north, from the radii of curvature of WGS84.
  const Eigen::Vector2d per_degree(76055.94, 111170.84);
  const Eigen::Vector2d way = 1e-5 * (b - a).cwiseProduct(per_degree);
  const RunOutcome lonlat =
      solved(terrain + "degrees.vrt}\n" + ends_at("lonlat", degrees.place(8, 20), degrees.place(30, 8)), dir);
  CHECK(lonlat.result.status == Status::certified);
  CHECK(lonlat.result.curve.cost == Approx(std::hypot(way.norm(), up)).epsilon(1e-5));
  CHECK(notes_of_turning(lonlat) == 1);

  const std::string map = "manifold: euclidean\ncost: {type: cost_map, file: cost.vrt";
  const double straight = (b - a).norm() * 0.5 * (Turned::unit_cost(a) + Turned::unit_cost(b));
  const RunOutcome cost = solved(map + "}\ninitializer: straight\nsolver: none\n" + in_crs, dir);
  CHECK(cost.result.initial_cost == Approx(straight).epsilon(2e-3));
  CHECK(notes_of_turning(cost) == 1);
  const RunOutcome cells = solved(map + ", interpolation: cells}\n" + in_crs, dir);
  CHECK(cells.result.curve.cost < straight);
  CHECK(cells.result.curve.cost > 0.98 * straight);

  // Outside of the rotated rectangle there are no data, though within that of the cells along the axes.
  CHECK_THROWS_WITH(solved(terrain + "utm.vrt}\n" + ends_at("point", utm.place(8, 20), utm.place(-4, 2)), dir),
                    Catch::Contains("target"));
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
  // A cost map that is read as its cells, which is the default, has one too.
  write_run(solve(parse_run("manifold: euclidean\ncost: {type: cost_map, file: utm.tif}\nends: {source: {point: "
                            "[500100, 5200200]}, target: {point: [500300, 5200400]}}\npath: {points: 9}\n"
                            "output: {files: [result, gpkg]}\n",
                            "b.yaml", dir.path())),
            dir / "cells", {});
  CHECK_THAT(output_of("ogrinfo -so '" + (dir / "cells/path.gpkg").string() + "' points 2>&1"),
             Catch::Contains("Feature Count: 11"));
}

TEST_CASE("GDAL: what it cannot read is an error with the name of the file") {
  const ScratchDir dir;
  std::ofstream(dir / "a.tif") << "no raster";
  CHECK_THROWS_WITH(read_gdal_raster(dir / "a.tif"), Catch::Contains("a.tif: cannot be read as a raster"));
  CHECK_THROWS_WITH(read_gdal_raster(dir / "b.tif"), Catch::Contains("b.tif: no such file"));
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
