// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/shapes/height_field.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include "tests/problems/sample_rasters.hpp"
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Catch::Contains;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Vector = Eigen::VectorXd;

std::string refusal(const HeightFieldOptions& options) {
  try {
    check(options);
    make_height_field(raster_of_heights(options), options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

HeightFieldOptions with_heights(const MatrixXd& heights) {
  HeightFieldOptions options;
  options.heights = heights;
  return options;
}

}  // namespace

TEST_CASE("height fields: level ground is a box, also where it is turned") {
  HeightFieldOptions options = with_heights(MatrixXd::Constant(4, 5, 0.5));
  options.raster.cell = Eigen::VectorXd::Constant(1, 0.5);
  options.raster.origin = Eigen::Vector2d(-1.25, -1);  // the middles of its cells: -1 to 1, -0.75 to 0.75
  options.depth = 1.5;
  for (const ShapePose& pose :
       {ShapePose{}, ShapePose{.position = Vector3d(0.3, -0.2, 1), .rpy = Vector3d(0.4, 1, -2)}}) {
    options.pose = pose;
    const auto field = make_height_field(raster_of_heights(options), options);
    const auto box = make_box({.lower = Vector3d(-1, -0.75, -1), .upper = Vector3d(1, 0.75, 0.5), .pose = pose});
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> place(-2, 2);
    const auto random_point = [&]() -> Vector { return Vector3d(place(engine), place(engine), place(engine)); };
    int within = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vector a = random_point(), b = random_point();
      CAPTURE(k, a.transpose(), b.transpose());
      Vector away(3), expected(3);
      const double truth = box->distance(a, expected);
      CHECK(field->distance(a, away) == Approx(truth).margin(1e-12));
      if (truth > 0) CHECK((away - expected).norm() < 1e-9);
      double t = -1, u = -1;
      CHECK(field->distance_of_segment(a, b, t) == Approx(box->distance_of_segment(a, b, u)).margin(1e-12));
      within += truth < 0 ? 1 : 0;
    }
    CHECK(within > 50);
  }
}

TEST_CASE("height fields: the surface goes through the heights, below it is solid") {
  const RasterGrid raster = test::raster_of(9, 7, test::waves);
  const auto field = make_height_field(raster, {});
  CHECK(field->name() == "the height field");
  Vector away(3);
  for (int row = 0; row + 1 < raster.rows; ++row) {
    for (int column = 0; column + 1 < raster.columns; ++column) {
      const Eigen::Vector2d at = raster.place(row, column), next = raster.place(row + 1, column + 1);
      const Vector3d corner(at[0], at[1], raster.value(row, column));
      CHECK(std::abs(field->distance(corner, away)) < 1e-14);
      const Eigen::Vector2d middle = (at + next) / 2;
      const double height = (raster.value(row, column) + raster.value(row + 1, column + 1)) / 2;  // on the diagonal
      const double above = field->distance(Vector3d(middle[0], middle[1], height + 0.1), away);
      CHECK(above > 0.02);
      CHECK(above <= 0.1 + 1e-12);
      CHECK(away[2] > 0);
      CHECK(field->distance(Vector3d(middle[0], middle[1], height - 0.1), away) < -0.02);
      double t = -1;
      CHECK(field->distance_of_segment(Vector3d(middle[0], middle[1], 9), Vector3d(middle[0], middle[1], height - 1),
                                       t) == 0);
      CHECK(9 + t * (height - 10) == Approx(height).margin(1e-12));
    }
  }
  // Under it there is ground as deep as it is wide.
  const Eigen::Vector2d middle = raster.place(4, 3);
  CHECK(field->distance(Vector3d(middle[0], middle[1], -2), away) < -0.9);
  // Rows of numbers begin in the north.
  const auto turned = with_heights((MatrixXd(2, 2) << 3, 3, 1, 1).finished());
  CHECK(std::abs(make_height_field(raster_of_heights(turned), turned)->distance(Vector3d(1, 1.5, 3), away)) < 1e-14);
}

TEST_CASE("height fields: what has no surface is refused in words") {
  const MatrixXd good = MatrixXd::Constant(2, 3, 1);
  CHECK(refusal(with_heights(good)) == "");
  CHECK_THAT(refusal({}), Contains("is missing: a height field has the file of a raster, or 'heights'"));
  CHECK(refusal(with_heights(good.topRows(1))) ==
        "heights: a height field has at least 2 x 2 heights, and this one has 1 x 3");
  MatrixXd gap = good;
  gap(0, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THAT(refusal(with_heights(gap)), Contains("row 0, column 2 of heights has no height"));
  CHECK_THAT(refusal(with_heights(MatrixXd::Constant(2, 2, std::numeric_limits<double>::infinity()))),
             Contains("no cell of the raster has data"));
  gap(0, 2) = 1e80;
  CHECK_THAT(refusal(with_heights(gap)), Contains("too large for a height"));
  HeightFieldOptions both = with_heights(good);
  both.raster.file = "dem.asc";
  CHECK_THAT(refusal(both), Contains("must not be given beside 'file'"));
  HeightFieldOptions flat = with_heights(good);
  flat.depth = 0;
  CHECK_THAT(refusal(flat), Contains("must be a number greater than 0"));
  HeightFieldOptions plane = with_heights(good);
  plane.pose.angle = 1;
  CHECK(refusal(plane) != "");
}

}  // namespace leastcost
