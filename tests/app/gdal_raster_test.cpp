// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Rasters by GDAL, against the same raster read by our own readers.
#include <leastcost/gdal/gdal_raster.hpp>

#include <fstream>

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
