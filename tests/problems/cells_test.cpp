// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Cost maps that are constant in each cell, against what needs none of their code: Snell's law by bisection, paths over
// the centres of cells, differences.
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/initializers/cell_graph.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include "problems/cells/beside_sides.hpp"
#include "problems/cells/cell_bound.hpp"
#include "problems/cells/cell_graph.hpp"
#include "problems/cells/cell_refraction.hpp"
#include "problems/cells/corner_turn.hpp"
#include "problems/raster/raster_cells.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

RasterGrid cells_of_size(int rows, int columns, const Vector2d& cell, double value) {
  RasterGrid raster;
  raster.rows = rows, raster.columns = columns;
  raster.cell = cell;
  raster.corner = {-3, 7};
  raster.values.assign(static_cast<std::size_t>(rows * columns), value);
  return raster;
}

/// Noise, or plateaus with corridors and holes.
RasterGrid random_cells(unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> part(0, 1);
  RasterGrid raster = cells_of_size(10 + static_cast<int>(seed), 14, {1.5, 0.8}, 60);
  if (seed % 2 == 0)
    for (double& value : raster.values) value = 1 + 9 * part(engine);
  for (int k = 0; seed % 2 == 1 && k < 3; ++k) {
    const int row = static_cast<int>(part(engine) * raster.rows), column = static_cast<int>(part(engine) * 14);
    for (int c = 0; c < 14; ++c) raster.values[raster.index(row, c)] = 1 + part(engine);
    for (int r = 0; r < raster.rows; ++r) raster.values[raster.index(r, column)] = 1 + part(engine);
  }
  for (int k = 0; k < 6; ++k)
    raster.values[raster.index(2 + static_cast<int>(part(engine) * (raster.rows - 4)),
                               2 + static_cast<int>(part(engine) * 10))] = kNoData;
  return raster;
}

double cost_of_move(const RasterGrid& raster, const Vector2d& a, const Vector2d& b) {
  Eigen::Matrix2Xd move(2, 2);
  move << a, b;
  return cost_over_cells(raster, move);
}

/// The least-cost path over the centres of cells, moves to all cells up to two away, each read exactly.
double cost_over_centres(const RasterGrid& raster) {
  std::vector<double> reached(raster.values.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
  reached[0] = 0;
  open.emplace(0, 0);
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    if (cost > reached[static_cast<std::size_t>(at)]) continue;
    const int row = at / raster.columns, column = at % raster.columns;
    for (int r = std::max(0, row - 2); r <= std::min(raster.rows - 1, row + 2); ++r)
      for (int c = std::max(0, column - 2); c <= std::min(raster.columns - 1, column + 2); ++c) {
        if (std::gcd(r - row, c - column) != 1) continue;
        const double there = cost + cost_of_move(raster, raster.place(row, column), raster.place(r, c));
        if (!(there < reached[raster.index(r, c)])) continue;
        reached[raster.index(r, c)] = there;
        open.emplace(there, r * raster.columns + c);
      }
  }
  return reached.back();
}

Eigen::Matrix2Xd as_columns(const CellPath& path) {
  Eigen::Matrix2Xd x(2, static_cast<Eigen::Index>(path.size()));
  for (std::size_t i = 0; i < path.size(); ++i) x.col(static_cast<Eigen::Index>(i)) = path[i];
  return x;
}

RefractedCellPath least(const CellMap& map, const Vector2d& a, const Vector2d& b) {
  return refract_in_cells(map, least_cell_path(map, a, b, 3));
}

}  // namespace

TEST_CASE("cells: the path is never dearer than one over the centres, obeys Snell's law, and lies above the bound") {
  for (unsigned seed = 0; seed < 6; ++seed) {
    CAPTURE(seed);
    const RasterGrid raster = random_cells(seed);
    const CellMap map(raster);
    const Vector2d a = raster.place(0, 0), b = raster.place(raster.rows - 1, raster.columns - 1);
    const RefractedCellPath found = least(map, a, b);
    CHECK(found.finished);
    CHECK(found.cost < cost_over_centres(raster));
    CHECK(cost_over_cells(raster, as_columns(found.path)) == Approx(found.cost).epsilon(1e-13));
    CHECK(found.least <= found.cost);
    CHECK(found.least >= found.cost * (1 - 1e-11));
    for (const Crossing& crossing : measure_cell_crossings(map, as_columns(found.path)))
      CHECK(crossing.mismatch <= 1e-10 + crossing.rounding);
    const CellBound bound = bound_in_cells(map, a, b, {.upper = found.cost, .most_places = 2000});
    CHECK(bound.lower <= found.cost);
    CHECK(bound.lower > 0.95 * found.cost);
  }
}

TEST_CASE("cells: between two media it is the ray of Snell's law") {
  RasterGrid raster = cells_of_size(2, 1, {20, 5}, 1);
  raster.values = {1, 3};
  const CellMap map(raster);
  const Vector2d a = raster.corner + Vector2d(1, 1), b = raster.corner + Vector2d(13, 8);
  double low = a[0], high = b[0];  // where the slownesses along the side agree
  for (int k = 0; k < 200; ++k) {
    const double x = (low + high) / 2;
    const double before = (x - a[0]) / std::hypot(x - a[0], 4), after = 3 * (b[0] - x) / std::hypot(b[0] - x, 3);
    (before < after ? low : high) = x;
  }
  const RefractedCellPath found = least(map, a, b);
  REQUIRE(found.path.size() == 3);
  CHECK(found.path[1][0] == Approx(low).epsilon(1e-13));
  CHECK(found.path[1][1] == raster.corner[1] + 5);
}

TEST_CASE("cells: along the side of a cheap cell, and where nothing else leads through the corner of two holes") {
  RasterGrid strip = cells_of_size(3, 5, {1, 1}, 10);
  for (int c = 0; c < 5; ++c) strip.values[strip.index(0, c)] = 1;
  const CellMap map(strip);
  const Vector2d up = strip.corner + Vector2d(0.25, 1), over = strip.corner + Vector2d(4.75, 1);  // on the side
  CHECK(least(map, up, over).cost == Approx(4.5).epsilon(1e-14));
  const Vector2d high = strip.corner + Vector2d(0.25, 1.2);
  const double down = 0.2 * std::sqrt(99.0);  // by the critical angle, then along
  CHECK(least(map, high, over).cost == Approx(4.5 + down).epsilon(1e-12));

  RasterGrid holes = cells_of_size(2, 2, {1, 1}, 2);
  holes.values[1] = holes.values[2] = kNoData;
  const Vector2d a = holes.corner + Vector2d(0.5, 0.2), middle = holes.corner + Vector2d(1, 1),
                 b = holes.corner + Vector2d(1.7, 1.5);
  const RefractedCellPath found = least(CellMap(holes), a, b);
  CHECK(found.path == CellPath{a, middle, b});
  holes.values[0] = kNoData;
  CHECK(least_cell_path(CellMap(holes), middle, b, 3).size() == 2);
  holes.values[3] = kNoData;
  CHECK(CellMap(holes).why_no_end(b) != "");
}

TEST_CASE("cells: a corner that a path should not meet is left by the cheaper side") {
  RasterGrid raster = cells_of_size(2, 2, {1, 1}, 1);
  raster.values[1] = 4;  // lower right
  const CellMap map(raster);
  const Vector2d a = raster.corner + Vector2d(0.2, 0.4), corner = raster.corner + Vector2d(1, 1),
                 b = raster.corner + Vector2d(1.5, 1.7);
  const RefractedCellPath found = refract_in_cells(map, {a, corner, b});
  CHECK(found.cost == Approx((b - a).norm()).epsilon(1e-13));  // by the upper left one
  const auto turn = corner_turn(map, a, corner, b, false), other = corner_turn(map, a, corner, b, true);
  REQUIRE((turn && other));
  CHECK(steepest_fall(*turn, corner) > 0);
  CHECK(steepest_fall(*other, corner) < 0);
  REQUIRE(turn->chain.gates.size() == 2);
  double most = 0;  // by differences, per length along the first gate
  for (double share = 0; share < 20; share += 1e-3) {
    const double h = 1e-7;
    const std::vector<double> s = {corner[turn->chain.gates[0].axis] + h * turn->outward[0],
                                   corner[turn->chain.gates[1].axis] + h * share * turn->outward[1]};
    most = std::max(most, ((corner - a).norm() + (b - corner).norm() - turn->chain.cost(s)) / h);
  }
  CHECK(steepest_fall(*turn, corner) == Approx(most).margin(1e-5));
}

TEST_CASE("cells: the bound of a map that is the same everywhere is the straight line") {
  const CellMap map(cells_of_size(6, 9, {1, 1}, 2));
  const Vector2d a(-2.7, 7.3), b(5.6, 12.1);
  const double straight = 2 * (b - a).norm();
  const CellBound bound = bound_in_cells(map, a, b, {.upper = straight, .most_places = 1000});
  CHECK(bound.lower <= straight);
  CHECK(bound.lower > 0.99 * straight);
}

TEST_CASE("cells: a cost map has them, in the plane") {
  const RasterGrid raster = random_cells(2);
  const auto cost = make_cost_map(raster, CostMapInterpolation::cells, 2);
  Eigen::Matrix2Xd curve(2, 3);
  curve << -2.5, 4.1, 15, 7.3, 7.2, 9.4;
  const double exact = cost_over_cells(raster, curve);
  REQUIRE(std::isfinite(exact));
  CHECK(find_ability<HasRasterCells>(*cost)->cost_over_cells(curve) == exact);
  CHECK_THROWS_WITH(make_cost_map(raster, CostMapInterpolation::cells, 3),
                    Catch::Contains("use 'smooth' or 'bilinear'"));
}

namespace {

/// As a program reads it for which a side belongs to the cell on its right, or above: the mean at many places.
double cost_by_samples(const RasterGrid& raster, const Eigen::MatrixXd& curve) {
  constexpr int kSamples = 64;
  double sum = 0;
  for (Index i = 0; i + 1 < curve.cols(); ++i)
    for (int k = 0; k < kSamples; ++k) {
      const Vector2d x = curve.col(i) + (curve.col(i + 1) - curve.col(i)) * (k + 0.5) / kSamples;
      const int column = static_cast<int>(std::floor((x[0] - raster.corner[0]) / raster.cell[0]));
      const int row = static_cast<int>(std::floor((x[1] - raster.corner[1]) / raster.cell[1]));
      sum += (curve.col(i + 1) - curve.col(i)).norm() / kSamples * raster.value(row, column);
    }
  return sum;
}

}  // namespace

TEST_CASE("cells: what is delivered costs the same to programs that take a side to be of one cell") {
  for (const double far : {0.0, 5e6}) {
    RasterGrid raster = random_cells(4);
    raster.corner += Vector2d(far, far);
    const auto cost = make_cost_map(raster, CostMapInterpolation::cells, 2);
    const Problem problem =
        between(space(2), cost, raster.place(0, 0), raster.place(raster.rows - 1, raster.columns - 1));
    const FirstPath first = CellGraphInitializer().first_path(problem, {});
    PostProcessed chain;
    chain.chain = first.path;
    const PostProcessed found = RefractCellsPostProcessor().apply(problem, first, chain, {});
    // Far away the first and last places of such a move are on the side again, to rounding.
    CHECK(cost_by_samples(raster, found.curve.x) == Approx(found.curve.cost).epsilon(far > 0 ? 1e-3 : 1e-9));
    const Eigen::Matrix2Xd path = onto_sides(CellMap(raster), found.curve.x);
    REQUIRE(path.cols() < found.curve.x.cols());  // some moves are along sides
    CHECK(cost_over_cells(raster, path) == Approx(found.curve.cost).epsilon(far > 0 ? 1e-9 : 1e-13));
    CHECK(*found.curve.straightness >= -1e-10);
  }
}

TEST_CASE("cells: over plateaus the path is straight, through corners too") {
  // Equal costs, and lines through many corners: to the left of no data, as around a lake.
  for (const int across : {1, 2, 3, 5, 8})
    for (const double cell : {1.0, 10.0, 0.3}) {
      RasterGrid raster = cells_of_size(16, 16, {cell, cell}, 2);
      for (int row = 4; row < 12; ++row)
        for (int column = 0; column < 10; ++column) raster.values[raster.index(row, column)] = kNoData;
      const CellMap map(raster);
      const Vector2d a = raster.place(14, across), b = raster.place(1, 2);
      const RefractedCellPath found = least(map, a, b);
      const Vector2d upper = raster.corner + cell * Vector2d(10, 12), lower = raster.corner + cell * Vector2d(10, 4);
      CAPTURE(across, cell);
      CHECK(found.cost == Approx(2 * ((upper - a).norm() + 8 * cell + (b - lower).norm())).epsilon(1e-13));
      for (const Crossing& crossing : measure_cell_crossings(map, as_columns(found.path)))
        CHECK(crossing.mismatch <= 1e-10 + crossing.rounding);
    }
}

TEST_CASE("cells: ends on corners, where rounding makes costs that are not quite 0") {
  for (const double cell : {0.1, 1.0 / 3, 25.0})
    for (int row = 0; row <= 4; ++row)
      for (int column = 0; column <= 4; ++column) {
        RasterGrid raster = cells_of_size(4, 4, {cell, cell}, 5);
        raster.corner = {-3.3, 7.7};
        const CellMap map(raster);
        const Vector2d a(map.line(0, 2), map.line(1, 1)), b(map.line(0, column), map.line(1, row));
        if (a == b) continue;
        const RefractedCellPath found = least(map, a, b);
        CHECK(found.cost == Approx(5 * (b - a).norm()).epsilon(1e-12));
        const CellBound bound = bound_in_cells(map, a, b, {.upper = found.cost, .most_places = 1000});
        CHECK(bound.lower <= found.cost);
        CHECK(bound.lower > 0.9 * found.cost);
      }
}

TEST_CASE("cells: lines that pass corners however near by") {
  const CellMap map(cells_of_size(20, 20, {1, 1}, 0.3));
  const Vector2d corner(map.line(0, 9), map.line(1, 7)), a = corner - Vector2d(8.5, 6.5), way(17.3, 13.1);
  for (double off = 1e-3; off > 1e-13; off /= 3)
    for (const double side : {off, -off}) {
      // Through the corner but for `side`.
      const Vector2d b = a + (corner + side * Vector2d(-way[1], way[0]).normalized() - a) * 2;
      const RefractedCellPath found = least(map, a, b);
      CAPTURE(side);
      CHECK(found.cost == Approx(0.3 * (b - a).norm()).epsilon(1e-12));
      for (const Crossing& crossing : measure_cell_crossings(map, as_columns(found.path)))
        CHECK(crossing.mismatch <= 1e-10 + crossing.rounding);
    }
}

TEST_CASE("cells: a side is found far from the origin, where a coordinate has few digits left") {
  RasterGrid raster = cells_of_size(2, 2, {0.2, 0.2}, 1.5);
  raster.corner = {500000, 5000000};
  raster.values[raster.index(1, 0)] = raster.values[raster.index(1, 1)] = kNoData;
  const auto cost = make_cost_map(raster, CostMapInterpolation::cells, 2);
  const CellMap map(raster);
  const Vector2d a(map.line(0, 0), map.line(1, 1)), b(map.line(0, 2), map.line(1, 1));
  const Problem problem = between(space(2), cost, a, b);
  const FirstPath first = CellGraphInitializer().first_path(problem, {});
  CHECK(PathEnergy(problem, 1).cost(first.path) == Approx(0.6).epsilon(1e-7));
}

TEST_CASE("cells: a short leg within a path excuses no bend, nor does a leg that shares no cell") {
  RasterGrid raster = cells_of_size(4, 6, {1, 1}, 2);
  raster.corner = {0, 0};
  const auto refused = [&](const Eigen::Matrix2Xd& polyline) {
    for (const Crossing& crossing : measure_cell_crossings(CellMap(raster), polyline))
      if (crossing.mismatch > 1e-10 + crossing.rounding) return true;
    return false;
  };
  Eigen::Matrix2Xd bent(2, 4);  // up to the side at y = 1, and down again
  bent << 0.25, 0.5, 0.5 + 3e-14, 0.75, 0.5, 1, 1, 0.5;
  CHECK(refused(bent));
  raster.values[raster.index(0, 2)] = kNoData;
  Eigen::Matrix2Xd across(2, 4);
  across << 0.5, 1, 3, 3.5, 0.5, 0.5, 0.5, 0.5;
  CHECK(refused(across));
}

}  // namespace leastcost::test
