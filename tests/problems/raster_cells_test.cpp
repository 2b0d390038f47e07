// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/raster_cells.hpp"

#include <cmath>
#include <limits>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// 3 x 2 cells of 10 by 5, the lower left corner at (100, 200).
RasterGrid raster() {
  RasterGrid grid;
  grid.rows = 2, grid.columns = 3;
  grid.cell = {10, 5};
  grid.corner = {100, 200};
  grid.values = {1, 2, 4, 8, 16, kNone};
  return grid;
}

double cost(const Eigen::MatrixXd& curve) { return cost_over_cells(raster(), curve); }

}  // namespace

TEST_CASE("raster cells: each part of a path costs what its cell says") {
  Eigen::MatrixXd curve(2, 2);
  curve << 105, 125, 202, 202;
  CHECK(cost(curve) == Approx(5 * 1 + 10 * 2 + 5 * 4).epsilon(1e-14));
  curve << 104, 104, 201, 209;
  CHECK(cost(curve) == Approx(4 * 1 + 4 * 8).epsilon(1e-14));
  curve << 105, 115, 202.5, 207.5;  // through the corner of four cells
  CHECK(cost(curve) == Approx(std::sqrt(125.0) * 0.5 * (1 + 16)).epsilon(1e-14));
  curve << 115, 105, 207.5, 202.5;
  CHECK(cost(curve) == Approx(std::sqrt(125.0) * 0.5 * (1 + 16)).epsilon(1e-14));
}

TEST_CASE("raster cells: along a side the cheaper cell counts") {
  Eigen::MatrixXd curve(2, 3);
  curve << 102, 110, 110, 205, 205, 201;
  CHECK(cost(curve) == Approx(8 * 1 + 4 * 1).epsilon(1e-14));
}

TEST_CASE("raster cells: without data, or beyond the raster, no path leads") {
  Eigen::MatrixXd curve(2, 2);
  curve << 115, 125, 207, 207;
  CHECK(std::isinf(cost(curve)));
  curve << 105, 95, 202, 202;
  CHECK(std::isinf(cost(curve)));
}

TEST_CASE("raster cells: in space lengths are those in space, and every cost map has them") {
  RasterGrid flat = raster();
  flat.values.back() = 1;
  Eigen::MatrixXd curve(3, 2);
  curve << 101, 104, 201, 201, 0, 4;
  for (const CostMapInterpolation between : {CostMapInterpolation::smooth, CostMapInterpolation::bilinear})
    CHECK(find_ability<HasRasterCells>(*make_cost_map(flat, between, 3))->cost_over_cells(curve) ==
          Approx(5).epsilon(1e-14));
}

}  // namespace leastcost::test
