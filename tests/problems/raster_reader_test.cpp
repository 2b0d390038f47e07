// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/readers/raster_reader.hpp"

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

const std::string kHead = "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 2.5\n";

std::string refusal_of_grid(const std::string& text) {
  try {
    read_esri_grid(text, "a.asc");
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string refusal_of_table(const std::string& text) {
  try {
    read_csv_raster(text, "a.csv");
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string key_of(const RasterOptions& options, const RasterFile& file) {
  try {
    placed(file, options);
    return "accepted";
  } catch (const OptionError& error) {
    return error.key();
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("ESRI grid: the first line of the file is the northernmost row") {
  const RasterFile file = read_esri_grid(kHead + "NODATA_value -9999\n1 2 3\n4 5 -9999\n", "a.asc");
  CHECK(file.nodata == -9999);
  const RasterGrid raster = placed(file, {});
  CHECK(raster.rows == 2);
  CHECK(raster.columns == 3);
  CHECK(raster.value(1, 0) == 1);
  CHECK(raster.value(0, 1) == 5);
  CHECK(std::isnan(raster.value(0, 2)));
  CHECK(raster.place(0, 0) == Eigen::Vector2d(11.25, 21.25));
  CHECK(raster.place(1, 2) == Eigen::Vector2d(16.25, 23.75));
  CHECK(raster.name_of(1, 2) == "row 0, column 2 of a.asc");
}

TEST_CASE("ESRI grid: keys in any order and case, middles of cells, two sides, values across lines, CR LF") {
  const RasterFile file =
      read_esri_grid("NROWS 2\r\nNCOLS 2\r\nXLLCENTER 1\r\nYLLCENTER 3\r\nDX 2\r\nDY 4\r\n1\r\n2 3\r\n-1e3", "a.asc");
  CHECK(file.raster.corner == Eigen::Vector2d(0, 1));
  CHECK(file.raster.cell == Eigen::Vector2d(2, 4));
  CHECK(file.raster.value(1, 1) == 2);
  CHECK(file.raster.value(0, 1) == -1000);
}

TEST_CASE("ESRI grid: what is wrong, with its line") {
  using Catch::Contains;
  CHECK(refusal_of_grid(kHead + "1 2 3 4 5 6") == "accepted");
  CHECK_THAT(refusal_of_grid(kHead + "1 2 3\n4    5"), Contains("a.asc:7: the file ends after 5 of 6 values"));
  CHECK_THAT(refusal_of_grid(kHead + "1 2 3\n4 5 6 7"), Contains("a.asc:7: more values than the header says (6)"));
  CHECK_THAT(refusal_of_grid(kHead + "1 2 x\n4 5 6"), Contains("a.asc:6: expected a value of the grid, found 'x'"));
  CHECK_THAT(refusal_of_grid("ncols 3\nrows 2\n1"), Contains("a.asc:2: expected a key of an ESRI ASCII grid"));
  CHECK_THAT(refusal_of_grid("ncols 3\nncols 2\n1"), Contains("a.asc:2: a second ncols"));
  CHECK_THAT(refusal_of_grid("ncols 3\nnrows 2\ncellsize 1\nyllcorner 0\n1"),
             Contains("neither xllcorner nor xllcenter"));
  CHECK_THAT(refusal_of_grid("ncols 2.5\nnrows 2\ncellsize 1\n1"), Contains("a.asc:1: ncols must be a whole number"));
  CHECK_THAT(refusal_of_grid("ncols 2\nnrows 2\ncellsize 0\n1"), Contains("a.asc:3: cellsize must be greater than 0"));
  CHECK_THAT(refusal_of_grid("ncols 10000\nnrows 10000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3"),
             Contains("but the file has only"));
  CHECK_THAT(refusal_of_grid("ncols 100000000\nnrows 100000000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3"),
             Contains("at most"));
  CHECK_THAT(refusal_of_grid(""), Contains("the file ends before the values"));
}

TEST_CASE("table: commas, semicolons or blanks, and empty fields, NA and nan are no data") {
  const RasterGrid raster = placed(read_csv_raster("# heights\n1,2,3\n\n4,,NA\r\n", "a.csv"), {});
  CHECK(raster.rows == 2);
  CHECK(raster.columns == 3);
  CHECK(raster.value(1, 2) == 3);
  CHECK(raster.value(0, 0) == 4);
  CHECK(std::isnan(raster.value(0, 1)));
  CHECK(std::isnan(raster.value(0, 2)));
  CHECK(read_csv_raster("1; 2\nnan;4\n", "a.csv").raster.value(1, 1) == 2);
  CHECK(read_csv_raster("\xEF\xBB\xBF"
                        "1,2\n3,4\n",
                        "a.csv")
            .raster.value(1, 0) == 1);
  CHECK(read_csv_raster(" 1   2\t3 \n4 5 6", "a.csv").raster.columns == 3);
}

TEST_CASE("table: what is wrong, with its line") {
  using Catch::Contains;
  CHECK_THAT(refusal_of_table("1,2\n3\n"), Contains("a.csv:2: 1 values, but the rows before have 2"));
  CHECK_THAT(refusal_of_table("a,b\n1,2\n"), Contains("a.csv:1: expected a number or an empty field, found 'a'"));
  CHECK_THAT(refusal_of_table("# nothing\n"), Contains("has no values"));
}

TEST_CASE("a raster is placed by its file, or by options") {
  RasterFile file = read_esri_grid(kHead + "1 2 3\n4 5 -1\n", "a.asc");
  RasterOptions options;
  options.cell = Eigen::Vector2d(1, 2);
  options.origin = Eigen::Vector2d(-1, -2);
  options.nodata = -1;
  options.value_scale = 10;
  const RasterGrid raster = placed(file, options);
  CHECK(raster.place(1, 2) == Eigen::Vector2d(1.5, 1));
  CHECK(raster.value(0, 1) == 50);
  CHECK(std::isnan(raster.value(0, 2)));
  options.cell = Eigen::Vector3d(1, 1, 1);
  CHECK(key_of(options, file) == "cell");
  options.cell = Eigen::VectorXd::Constant(1, -1);
  CHECK(key_of(options, file) == "cell");
  options.cell = Eigen::VectorXd::Constant(1, 3);
  CHECK(key_of(options, file) == "accepted");
  options.origin = Eigen::VectorXd::Zero(1);
  CHECK(key_of(options, file) == "origin");
  options.origin.reset();
  options.value_scale = 0;
  CHECK(key_of(options, file) == "value_scale");
  options.value_scale = 1;
  options.degrees = true;
  options.origin = Eigen::Vector2d(0, 95);
  CHECK(key_of(options, file) == "degrees");
  file.raster.values.assign(6, -1);
  CHECK(key_of(options, file) == "a.asc: no cell of the raster has data");
}

TEST_CASE("a raster in degrees becomes metres that are true in its middle") {
  RasterOptions options;
  options.degrees = true;
  options.cell = Eigen::VectorXd::Constant(1, 0.01);
  options.origin = Eigen::Vector2d(6, 44.99);
  const RasterGrid raster = placed(read_csv_raster("1,2\n3,4\n", "a.csv"), options);
  REQUIRE(raster.degrees);
  CHECK(raster.corner == Eigen::Vector2d::Zero());
  // At 45 degrees north on WGS84 the axis is 4517590.8788 m away, and the meridian's radius of curvature 6367381.8156
  // m.
  CHECK(raster.degrees->per_degree[0] == Approx(4517590.8788 * kDegree).epsilon(1e-9));
  CHECK(raster.degrees->per_degree[1] == Approx(6367381.8156 * kDegree).epsilon(1e-9));
  CHECK(raster.cell[0] == Approx(45175.908788 * kDegree).epsilon(1e-9));
}

TEST_CASE("ESRI grid: nan, inf and NA are no data, also as NODATA_value, as R and C write them") {
  for (const char* none : {"nan", "NaN", "-nan", "inf", "-Inf", "NA", "*", "1.#QNAN", "-1.#IND"}) {
    const RasterGrid raster =
        placed(read_esri_grid(kHead + "NODATA_value " + none + "\n" + none + " 2 3\n4 " + none + " 6\n", "a.asc"), {});
    INFO(none);
    CHECK(std::isnan(raster.value(1, 0)));
    CHECK(std::isnan(raster.value(0, 1)));
    CHECK(raster.value(1, 1) == 2);
    CHECK(std::isnan(read_csv_raster("1," + std::string(none) + "\n3,4\n", "a.csv").raster.value(1, 1)));
  }
  CHECK_THAT(refusal_of_grid(kHead + "1 2 3\n4 north 6\n"), Catch::Contains("expected a value of the grid"));
}

TEST_CASE("rasters: heights in another unit than cells are no ground") {
  RasterGrid hills;
  hills.rows = 20, hills.columns = 30, hills.source = "hills.asc";
  hills.cell = {30, 30};
  for (int row = 0; row < hills.rows; ++row)
    for (int column = 0; column < hills.columns; ++column)
      hills.values.push_back(40 * std::sin(0.1 * row) * std::cos(0.2 * column));
  CHECK_NOTHROW(check_slopes(hills, {}));
  RasterGrid millimetres = hills, walls = hills;
  for (double& z : millimetres.values) z *= 1000;
  CHECK_THROWS_WITH(check_slopes(millimetres, {}), Catch::Contains("are heights in metres, as cells are?"));
  RasterOptions stated;
  stated.cell = Eigen::VectorXd::Constant(1, 30);
  CHECK_THROWS_AS(check_slopes(millimetres, stated), OptionError);
  for (double& z : millimetres.values) z *= 0.2;  // slopes about 30, and cells that somebody has thought about
  CHECK_THROWS_AS(check_slopes(millimetres, {}), OptionError);
  CHECK_NOTHROW(check_slopes(millimetres, stated));
  for (std::size_t i = 0; i < walls.values.size(); ++i) walls.values[i] = i % 30 == 7 ? 2000 : 0;
  CHECK_NOTHROW(check_slopes(walls, {}));
}

TEST_CASE("rasters: usual fill values in many cells are no data whatever the width of the raster") {
  for (const char* fill : {"-9999", "-32768", "-99999", "-999", "-3.4028235e+38", "-3.402823e38", "1e38", "3.4e38"})
    for (const double side : {1.0, 1e6}) {
      INFO(fill);
      std::string text = "ncols 3\nnrows 3\nxllcorner 10\nyllcorner 20\ncellsize " + std::to_string(side) + "\n";
      text += std::string("100 ") + fill + " 180\n240 " + fill + " 300\n120 130 140\n";
      std::string note;
      const RasterGrid raster = placed(read_esri_grid(text, "a.asc"), {}, &note);
      CHECK(std::isnan(raster.value(2, 1)));
      CHECK(std::isnan(raster.value(1, 1)));
      CHECK(raster.value(0, 1) == 130);
      CHECK_THAT(note,
                 Catch::Contains("was taken as \"no data\": 2 of 9 cells have it, the first is row 0, column 1 of "
                                 "a.asc") &&
                     Catch::Contains("set nodata to a number that no cell has"));
      RasterOptions otherwise;
      otherwise.nodata = 12345.6;
      note.clear();
      if (std::abs(std::stod(fill)) < 1e30) {
        CHECK(placed(read_esri_grid(text, "a.asc"), otherwise, &note).value(2, 1) == std::stod(fill));
        CHECK(note.empty());
      }
    }
}

TEST_CASE("rasters: heights and costs that look like fill values but are near the others are kept") {
  const auto kept = [](const std::string& values) {
    std::string note;
    const RasterGrid raster = placed(read_esri_grid(kHead + values, "a.asc"), {}, &note);
    CHECK(note.empty());
    return std::none_of(raster.values.begin(), raster.values.end(), [](double v) { return std::isnan(v); });
  };
  CHECK(kept("-9999 -9999 -9100\n-8000 -2000 0\n"));  // an ocean
  CHECK(kept("-9999 -9999 -20000\n-8000 -2000 0\n"));
  CHECK(kept("9999 9999 1\n1 2 3\n"));  // dear cells
  CHECK(kept("0 0 0\n300 301 302\n"));
}

TEST_CASE("rasters: a cliff of 300 m within 120 m is ground") {
  std::string text = "ncols 12\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 12; ++column) text += column < 6 ? "0 " : std::to_string(300 + row % 3) + " ";
  std::string note;
  const RasterGrid raster = placed(read_esri_grid(text, "cliff.asc"), {}, &note);
  CHECK(note.empty());
  CHECK_NOTHROW(check_heights(raster, {}));
  CHECK(check_slopes(raster, {}).empty());
}

TEST_CASE("rasters: most slopes above 60 degrees get a note that says what to write") {
  RasterGrid hills;
  hills.rows = 20, hills.columns = 30, hills.source = "hills.asc";
  hills.cell = {30, 30};
  for (int row = 0; row < hills.rows; ++row)
    for (int column = 0; column < hills.columns; ++column)
      hills.values.push_back(100 * 10 * std::sin(0.1 * row) * std::cos(0.2 * column));  // centimetres
  CHECK_THAT(check_slopes(hills, {}),
             Catch::Contains("steeper than 60 degrees") && Catch::Contains("0.01") && Catch::Contains("value_scale"));
  for (double& z : hills.values) z /= 20;
  CHECK(check_slopes(hills, {}).empty());
}

TEST_CASE("rasters: fill values that nobody declared are named with the option that declares them") {
  const auto refusal = [](const std::string& fill, RasterOptions options) {
    const RasterFile file = read_esri_grid(kHead + "1 2 3\n4 " + fill + " 6\n", "a.asc");
    try {
      check_heights(placed(file, options), options);
      return std::string("accepted");
    } catch (const OptionError& error) {
      return error.key() + ": " + error.reason();
    }
  };
  for (const char* fill : {"-32768", "-9999", "32767", "-3.4028235e+38", "1e+38"}) {
    const std::string message = refusal(fill, {});
    INFO(message);
    CHECK_THAT(message, Catch::StartsWith("nodata: row 1, column 1 of a.asc"));
    const std::size_t at = message.rfind("set nodata: ");
    REQUIRE(at != std::string::npos);
    RasterOptions mended;
    mended.nodata = std::stod(message.substr(at + 12));
    CHECK(refusal(fill, mended) == "accepted");
  }
  CHECK(refusal("12", {}) == "accepted");
}

}  // namespace leastcost::test
