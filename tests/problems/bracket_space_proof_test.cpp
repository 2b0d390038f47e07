// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <vector>

#include "problems/bracket/space/space_tube.hpp"
#include "tests/problems/planted_space.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using namespace bracket;
using Eigen::Vector3d;

constexpr double kUnknownInCube = std::numeric_limits<double>::quiet_NaN();

/// A cell of side 1 with random coefficients around a plane, and the largest length of its gradient at 9^3 places, in
/// long double.
struct RandomCube {
  CubeNet u = {};
  long double longest = 0;

  RandomCube(Random& random, double noise) {
    const double size = random.uniform(0.5, 2);
    const Vector3d along = size * Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    for (int k = 0; k < 27; ++k)
      u[static_cast<std::size_t>(k)] =
          along.dot(Vector3d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)) + noise * random.normal();
    constexpr int kParts = 8;
    for (int n = 0; n < (kParts + 1) * (kParts + 1) * (kParts + 1); ++n) {
      const auto at = [&](int i) { return static_cast<long double>(i % (kParts + 1)) / kParts - 0.5L; };
      longest = std::max(longest, slope({at(n), at(n / (kParts + 1)), at(n / (kParts + 1) / (kParts + 1))}));
    }
  }
  long double slope(const std::array<long double, 3>& at) const {
    std::array<std::array<long double, 3>, 3> w, d;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double t = at[k];
      w[k] = {(0.5L - t) * (0.5L - t) / 2, 0.75L - t * t, (0.5L + t) * (0.5L + t) / 2};
      d[k] = {t - 0.5L, -2 * t, t + 0.5L};
    }
    long double x = 0, y = 0, z = 0;
    for (std::size_t k = 0; k < 27; ++k) {
      const std::size_t p = k % 3, q = k / 3 % 3, r = k / 9;
      x += d[0][p] * w[1][q] * w[2][r] * u[k];
      y += w[0][p] * d[1][q] * w[2][r] * u[k];
      z += w[0][p] * w[1][q] * d[2][r] * u[k];
    }
    return std::sqrt(x * x + y * y + z * z);
  }
};

/// How often the rules claim less than the gradient has.
int false_space_claims(const CubeRules& rules, double noise, Random& random) {
  CubeNet one;
  one.fill(1);
  int wrong = 0;
  for (int k = 0; k < 120; ++k) {
    const RandomCube cell(random, noise);
    wrong += static_cast<long double>(proved_ratio(cell.u, 1, 4, one, rules)) < cell.longest ? 1 : 0;
  }
  return wrong;
}

}  // namespace

/// Mutations of the check are seen by the same comparison that the check itself passes.
TEST_CASE("bracket in space: the check of a cell, and checks that are not") {
  Random random;
  for (const double noise : {0.0, 1e-14, 1e-3, 0.3})
    for (const int halvings : {0, 1}) CHECK(false_space_claims({.halvings = halvings}, noise, random) == 0);
  CHECK(false_space_claims({.rounding = -1}, 0, random) > 30);
  for (const unsigned corner : {0U, 2U, 6U, 8U, 18U, 20U, 24U, 26U}) {
    CAPTURE(corner);
    CHECK(false_space_claims({.dropped = 1U << corner}, 0.3, random) > 0);
  }
}

TEST_CASE("bracket in space: where a coefficient is not known nothing is proved") {
  Random random;
  CubeNet one;
  one.fill(1);
  for (int k = 0; k < 400; ++k) {
    CubeNet u = RandomCube(random, 0.1).u;
    const double endless = std::numeric_limits<double>::infinity();
    const auto somewhere = [&] { return static_cast<std::size_t>(random.integer(0, 26)); };
    for (int n = random.integer(1, 3); n > 0; --n)
      u[somewhere()] = std::array<double, 3>{endless, -endless, kUnknownInCube}[static_cast<std::size_t>(k % 3)];
    if (k % 4 == 0) u[somewhere()] = -endless;
    CHECK(proved_ratio(u, 1, 4, one) == endless);
    CubeNet floor = one;
    floor[somewhere()] = kUnknownInCube;
    CHECK(proved_ratio(RandomCube(random, 0.1).u, 1, 4, floor) == endless);
  }
}

TEST_CASE("bracket in space: the floor of a density lies below it, and near") {
  Random random;
  for (int k = 0; k < 20; ++k) {
    const PlantedSpace medium = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(medium.cost());
    const SpaceGrid grid = SpaceGrid::over(medium.box, 40);
    Place cell;
    for (std::size_t axis = 0; axis < 3; ++axis) cell[axis] = random.integer(1, grid.cells[axis]);
    // Of a cube of cells to one side, as on finer grids.
    const Vector3d middle = Vector3d(cell[0], cell[1], cell[2]) + 0.5 * Vector3d::Ones();
    for (const bool alone : {false, true}) {
      const CubeNet floor = space_floor(*density, alone ? grid.cell(cell) : grid.cube(middle, 1)).on_cell(grid, cell);
      for (int n = 0; n < 50; ++n) {
        const Vector3d t(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
        const Vector3d x = grid.node(cell) + grid.h * (t - 0.5 * Vector3d::Ones());
        if (!medium.box.contains(x)) continue;
        double value = 0;
        for (std::size_t c = 0; c < 27; ++c) {
          double weight = 1;
          const std::array<std::size_t, 3> number = {c % 3, c / 3 % 3, c / 9};
          for (int axis = 0; axis < 3; ++axis) {
            const double s = t[axis];
            weight *= std::array<double, 3>{(1 - s) * (1 - s), 2 * s * (1 - s), s * s}[number[axis]];
          }
          value += weight * floor[c];
        }
        CHECK(value <= medium.density(x));
        CHECK(value >= medium.density(x) - 0.05);
      }
    }
  }
}

/// The cells around the ends: with those that the check left out the bound holds, with fewer it uses a part of the
/// potential that nobody has checked.
TEST_CASE("bracket in space: an end region that is too small is caught") {
  const std::shared_ptr<const SpaceDensity> density = isotropic_density("1");
  const std::function<bool()> never;
  const StopLook look(never);
  const Vector3d source(0.262, 0.512, 0.512), target(0.762, 0.512, 0.512);
  const std::function<double(const Vector3d&)> open;
  const SpaceLevel level =
      whole_space_level({*density, open}, {Vector3d(0, 0.2, 0.2), Vector3d(1, 0.8, 0.8)}, 40, look);
  const SpaceGrid& grid = level.grid;
  const EndBall s = end_ball(*density, grid, source, 3), t = end_ball(*density, grid, target, 3);
  REQUIRE(s.valid);
  REQUIRE(t.valid);
  REQUIRE(s.k == 3);
  std::vector<double> u(level.density.size()), ratios;
  for (int node = 0; node < level.nodes.none(); ++node)
    u[static_cast<std::size_t>(node)] = grid.coordinate(0, level.nodes.place(node)[0]);
  // Within the region of the source, seen by no cell outside.
  u[static_cast<std::size_t>(level.nodes.find(s.middle))] -= 0.3;
  const auto bound = [&](const EndBall& around_s, double ratio) {
    return rim_minimum(grid, level.nodes, around_s, level.searched, u, -1, ratio) +
           rim_minimum(grid, level.nodes, t, level.searched, u, 1, ratio);
  };
  const double truth = 0.5, ratio = check(level, u, s, t, ratios, look);
  CHECK(ratio < 1 + 1e-9);
  CHECK(bound(s, ratio) <= truth);
  CHECK(bound(s, ratio) > 0.9 * truth);
  EndBall small = s;
  small.k = 0;
  CHECK(bound(small, ratio) > truth);  // what a wrong region would claim
  CHECK(check(level, u, small, t, ratios, look) > 2);
  CHECK(bound(small, check(level, u, small, t, ratios, look)) <= truth);
}

/// v of the regions around the ends, against the costs of planted media: along their flow, whichever way it goes on.
TEST_CASE("bracket in space: the cone at an end lies below the cost") {
  Random random;
  int valid = 0;
  for (int k = 0; k < 40; ++k) {
    const PlantedSpace medium = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(medium.cost());
    const SpaceGrid grid = SpaceGrid::over(medium.box, random.integer(20, 80));
    const EndBall region = end_ball(*density, grid, medium.source, random.integer(1, 6));
    if (!region.valid) continue;
    ++valid;
    for (const Vector3d& x : medium.flow) {
      if (!region.holds(grid.place_at(x))) break;
      const Vector3d d = x - medium.source;
      const double cone = std::min(region.cone<double>({d[0], d[1], d[2]}), region.most);
      CHECK(cone <= (medium.u(x) - medium.u(medium.source)) * (1 + 1e-12) + 1e-15);
    }
  }
  CHECK(valid > 32);
}

/// No cell of the flow is left out for what costs a little more, and some are for what costs less than any path.
TEST_CASE("bracket in space: the cells of a cheaper path are searched", "[slow_sanitized]") {
  Random random;
  const std::function<bool()> never;
  const StopLook look(never);
  const std::function<double(const Vector3d&)> open;
  int wrong = 0;
  for (int k = 0; k < 10; ++k) {
    CAPTURE(k);
    const PlantedSpace planted = PlantedSpace::random(random);
    const std::shared_ptr<const SpaceDensity> density = space_density_of(planted.cost());
    const SpaceMedium medium{*density, open};
    const SpaceLevel level = whole_space_level(medium, planted.box, random.integer(16, 24), look);
    SpaceMarching marching(look);
    const auto bound = [&](const Vector3d& end, const Vector3d& other) {
      return distance_bound(level, distance_field(medium, level, end_ball(*density, level.grid, end, 2), marching),
                            other, marching);
    };
    const SpaceDistanceBound from_s = bound(planted.source, planted.target),
                             from_t = bound(planted.target, planted.source);
    if (!from_s.ball.valid || !from_t.ball.valid) continue;
    const SpaceGrid fine = level.grid.refined(4);
    const auto left_out = [&](double upper) {
      const std::vector<Place> cells = reached_cells(medium, level, from_s, from_t, upper, 4, look);
      const std::set<Place> searched(cells.begin(), cells.end());
      return std::ranges::count_if(planted.flow,
                                   [&](const Vector3d& x) { return !searched.contains(fine.place_at(x)); });
    };
    CHECK(left_out(planted.least_cost() * (1 + 1e-6)) == 0);
    wrong += left_out(0.8 * planted.least_cost()) > 0 ? 1 : 0;
  }
  CHECK(wrong > 2);
}

}  // namespace leastcost::test
