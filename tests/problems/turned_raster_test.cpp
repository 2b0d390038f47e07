// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/turned_raster.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

/// A file of columns x rows cells whose values are f(column + 0.5, row + 0.5).
template <class F>
RasterFile file_of(int columns, int rows, const RasterFile::Affine& turned, F f) {
  RasterFile file;
  file.raster.columns = columns;
  file.raster.rows = rows;
  file.raster.source = "a.tif";
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) file.raster.values.push_back(f(column + 0.5, row + 0.5));
  file.turned = turned;
  return file;
}

RasterFile::Affine affine(double ax, double ay, double bx, double by, double x, double y) {
  RasterFile::Affine turned;
  turned << ax, bx, x, ay, by, y;
  return turned;
}

}  // namespace

TEST_CASE("turned raster: heights that are linear in the place stay so, and only outside of the file are there none",
          "[raster]") {
  // Cells of 3 x 2, turned by 30 degrees; mirrored too, as rows downwards are.
  const double c = std::sqrt(0.75), s = 0.5;
  for (const double side : {2.0, -2.0}) {
    const RasterFile::Affine turned = affine(3 * c, 3 * s, -side * s, side * c, 1000, 2000);
    const auto height = [](const Eigen::Vector2d& p) { return 0.3 * (p[0] - 1000) + 0.2 * (p[1] - 2000); };
    std::string note;
    const RasterGrid grid = placed_upright(
        file_of(40, 30, turned,
                [&](double column, double row) { return height(turned * Eigen::Vector3d(column, row, 1)); }),
        {}, Resampling::bilinear, note);
    CHECK_THAT(note, Catch::Contains("a.tif is rotated by 30 degrees"));
    const Eigen::Matrix2d to_index = turned.leftCols<2>().inverse();
    long known = 0;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const Eigen::Vector2d place = grid.place(row, column), index = to_index * (place - turned.col(2));
        const bool inside = index.minCoeff() >= 0.5 && index[0] <= 39.5 && index[1] <= 29.5;
        REQUIRE(std::isfinite(grid.value(row, column)) == inside);
        if (inside) REQUIRE(std::abs(grid.value(row, column) - height(place)) < 1e-9);
        known += inside;
      }
    CHECK(static_cast<double>(known) * grid.cell.prod() == Approx(39 * 29 * 6.0).epsilon(0.01));  // the area
  }
}

TEST_CASE("turned raster: of costs every cell keeps its value, and none has another", "[raster]") {
  // Turned, stretched, sheared as a rotated raster in degrees is, and of one cell only.
  const RasterFile::Affine shapes[] = {affine(1, 1, -1, 1, 0, 0), affine(3, 0.4, -0.2, 1, 5, 5),
                                       affine(0.001, 0.0007, -0.0011, 0.0006, 8, 47), affine(1, 0.9, 0.9, 1, 0, 0)};
  for (const RasterFile::Affine& turned : shapes)
    for (const int size : {1, 12}) {
      std::string note;
      const RasterGrid grid =
          placed_upright(file_of(size, size, turned, [&](double column, double row) { return column + size * row; }),
                         {}, Resampling::nearest, note);
      std::vector<int> seen(static_cast<std::size_t>(size * size), 0);
      const Eigen::Matrix2d to_index = turned.leftCols<2>().inverse();
      for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
          const Eigen::Vector2d at = (to_index * (grid.place(row, column) - turned.col(2))).array().floor();
          if (std::isnan(grid.value(row, column))) continue;
          REQUIRE(grid.value(row, column) == at[0] + 0.5 + size * (at[1] + 0.5));
          ++seen[static_cast<std::size_t>(at[0] + size * at[1])];
        }
      for (const int count : seen) REQUIRE(count > 0);
    }
}

TEST_CASE("turned raster: a quarter turn has the cells of the file, whose sides change places", "[raster]") {
  std::string note;
  const RasterGrid grid = placed_upright(
      file_of(3, 2, affine(0, 5, -4, 0, 100, 0), [](double column, double row) { return column + 10 * row; }), {},
      Resampling::nearest, note);
  CHECK(grid.cell == Eigen::Vector2d(4, 5));
  CHECK(grid.corner == Eigen::Vector2d(92, 0));
  REQUIRE(grid.values.size() == 6);
  CHECK(grid.value(0, 0) == 15.5);  // column 0 of the upper row
  CHECK(grid.value(2, 1) == 7.5);
}

TEST_CASE("turned raster: fill values are found before they are mixed, options replace the place together",
          "[raster]") {
  const RasterFile::Affine turned = affine(1, 1, -1, 1, 0, 0);
  const auto file = [&](double fill) {
    return file_of(9, 9, turned, [&](double column, double row) { return column == 4.5 ? fill : 100 + row; });
  };
  std::string note;
  RasterOptions options;
  for (const double value : placed_upright(file(-32768), options, Resampling::bilinear, note).values)
    CHECK((std::isnan(value) || (value >= 100 && value <= 109)));
  CHECK_THAT(note, Catch::Contains("the value -32768 was taken as \"no data\"") && Catch::Contains("is rotated"));
  CHECK_THROWS_WITH(placed_upright(file(32767), options, Resampling::bilinear, note),
                    Catch::Contains("set nodata: 32767"));
  options.nodata = -32768;
  options.value_scale = 2;
  const RasterGrid grid = placed_upright(file(-32768), options, Resampling::bilinear, note);
  for (const double value : grid.values) CHECK((std::isnan(value) || (value >= 201 && value <= 217)));
  options.cell = Eigen::VectorXd::Constant(1, 10);
  CHECK_THROWS_WITH(placed_upright(file(-32768), options, Resampling::nearest, note),
                    Catch::Contains("give both cell and origin"));
  options.origin = Eigen::Vector2d(7, 8);
  note.clear();
  const RasterGrid plain = placed_upright(file(-32768), options, Resampling::nearest, note);
  CHECK(plain.columns == 9);
  CHECK(plain.corner == Eigen::Vector2d(7, 8));
  CHECK(note.empty());
}

namespace {

/// Whether a path over cells, by their corners too, comes from below row `wall` of the file to above it.
bool leaks(const RasterGrid& grid, const RasterFile::Affine& turned, int wall) {
  const Eigen::Matrix2d to_index = turned.leftCols<2>().inverse();
  const auto file_row = [&](int row, int column) { return (to_index * (grid.place(row, column) - turned.col(2)))[1]; };
  std::vector<int> open;
  std::vector<bool> seen(grid.values.size(), false);
  const auto visit = [&](int row, int column) {
    if (row < 0 || column < 0 || row >= grid.rows || column >= grid.columns) return;
    const std::size_t at = grid.index(row, column);
    if (seen[at] || std::isnan(grid.values[at])) return;
    seen[at] = true;
    open.push_back(static_cast<int>(at));
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (file_row(row, column) < wall) visit(row, column);
  while (!open.empty()) {
    const int row = open.back() / grid.columns, column = open.back() % grid.columns;
    open.pop_back();
    if (file_row(row, column) > wall + 1) return true;
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1}) visit(row + i, column + j);
  }
  return false;
}

}  // namespace

TEST_CASE("turned raster: a wall of one cell stays one, whatever the angle, the sides and the shear", "[raster]") {
  constexpr int kSize = 15, kWall = 7;
  for (const double width : {10.0, 5.0, 25.0})
    for (const double shear : {0.0, 0.4})
      for (int degrees = 1; degrees < 180; degrees += 7) {
        const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
        const RasterFile::Affine turned = affine(width * c, width * s, 8 * (shear * c - s), 8 * (shear * s + c), 3, 4);
        std::string note;
        const RasterGrid grid =
            placed_upright(file_of(kSize, kSize, turned,
                                   [&](double, double row) {
                                     return std::floor(row) == kWall ? std::numeric_limits<double>::quiet_NaN() : 1.0;
                                   }),
                           {}, Resampling::nearest, note);
        CAPTURE(width, shear, degrees);
        CHECK_FALSE(leaks(grid, turned, kWall));
      }
}

TEST_CASE("turned raster: a quarter turn that is one to rounding moves no border", "[raster]") {
  const double c = std::cos(std::numbers::pi / 2);  // 6e-17
  std::string note;
  const RasterGrid grid = placed_upright(
      file_of(20, 20, affine(10 * c, 10, -10, 10 * c, 500000, 5000000), [](double, double row) { return row; }), {},
      Resampling::nearest, note);
  CHECK(grid.columns == 20);
  CHECK(grid.rows == 20);
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column) REQUIRE(grid.value(row, column) == 19.5 - column);
}

}  // namespace leastcost::test
