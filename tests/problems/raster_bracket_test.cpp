// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Brackets of the least cost on cost maps: enclosures of the density, planted least costs, and paths that are there.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/bracket/search/bracket.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/problems/sample_rasters.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kNoWay = std::numeric_limits<double>::infinity();

int rasters_to_try(int otherwise) {
  const char* text = std::getenv("LEASTCOST_BRACKET_RASTERS");  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? trials(otherwise) : std::atoi(text);
}

/// Values exp(noise), or those of a few hills, or both; square cells two times out of three.
RasterGrid random_raster(Random& random) {
  RasterGrid raster;
  raster.rows = random.integer(4, 14);
  raster.columns = random.integer(4, 14);
  raster.cell.setConstant(random.uniform(0.2, 5));
  if (random.integer(0, 2) == 0) raster.cell[1] = random.uniform(0.2, 5);
  raster.corner << random.uniform(-50, 50), random.uniform(-50, 50);
  raster.source = "random";
  const double noise = random.uniform(0, 0.6), hill = random.uniform(0, 3);
  const Vector2d middle(random.uniform(0, raster.columns), random.uniform(0, raster.rows));
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column)
      raster.values.push_back((1 + hill * std::exp(-0.1 * (Vector2d(column, row) - middle).squaredNorm())) *
                              std::exp(noise * random.normal()));
  return raster;
}

AlignedBox2d box_of_values(const RasterGrid& raster) {
  return {raster.place(0, 0), raster.place(raster.rows - 1, raster.columns - 1)};
}

Vector2d place_in(const AlignedBox2d& box, Random& random) {
  return {random.uniform(box.min()[0], box.max()[0]), random.uniform(box.min()[1], box.max()[1])};
}

/// The cost of a polyline by the exact integral of the map.
double cost_of(const SegmentCost& cost, const Points& x) {
  std::vector<double> q(static_cast<std::size_t>(x.cols() - 1));
  cost.squared_costs({.x = {x.data(), x.rows(), x.cols()}, .sites = {}}, q);
  double sum = 0;
  for (const double squared : q) sum += std::sqrt(squared);
  return sum;
}

Problem problem_on(std::shared_ptr<const SegmentCost> cost, const AlignedBox2d& box, const Vector2d& source,
                   const Vector2d& target) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(
      EuclideanManifoldOptions{2, {Eigen::VectorXd(box.min()), Eigen::VectorXd(box.max())}});
  problem.cost = std::move(cost);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

/// How far n is from its enclosure without slack at places of a cell, at most, over the slack; 0 for no slack.
double worst_in_cell(const CostDensity& density, const AlignedBox2d& cell, Random& random) {
  const DensityEnclosure n = density.enclose_density(cell);
  REQUIRE(n.is_finite());
  double worst = 0;
  for (int k = 0; k < 40; ++k) {
    const Vector2d x = place_in(cell, random), d = x - cell.center();
    const Interval dx(d[0]), dy(d[1]);
    const Interval model =
        n.value + n.dx * dx + n.dy * dy + Interval(0.5) * (n.xx * square(dx) + n.yy * square(dy)) + n.xy * dx * dy;
    const double rounding =
        1e-13 * (std::abs(n.value.hi) + n.dx.magnitude() * cell.sizes()[0] + n.dy.magnitude() * cell.sizes()[1]);
    const double value = density.density(x), beyond = std::max(model.lo - value, value - model.hi);
    CHECK(beyond <= n.slack + rounding);
    if (n.slack > 0) worst = std::max(worst, beyond / n.slack);
  }
  return worst;
}

}  // namespace

TEST_CASE("raster bracket: the enclosure of a map's density holds it, and not by much") {
  Random random;
  double tightest = 0;
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const RasterGrid raster = random_raster(random);
    const AlignedBox2d box = box_of_values(raster);
    const auto interpolation = k % 2 == 0 ? CostMapInterpolation::bilinear : CostMapInterpolation::smooth;
    const std::shared_ptr<const CostDensity> density = density_of(make_cost_map(raster, interpolation, 2));
    REQUIRE(density);
    for (const double size : {0.0, 1e-9, 0.1, 1.0, 3.0}) {
      const Vector2d a = place_in(box, random), b = (a + size * raster.cell).cwiseMin(box.max());
      tightest = std::max(tightest, worst_in_cell(*density, {a, b}, random));
      const Vector2d corner = raster.place(random.integer(0, raster.rows - 1), random.integer(0, raster.columns - 1));
      worst_in_cell(*density, {corner, (corner + size * raster.cell).cwiseMin(box.max())}, random);
    }
  }
  CHECK(tightest > 0.5);  // a smaller slack would be wrong
  CHECK(tightest <= 1 + 1e-9);
}

TEST_CASE("raster bracket: nothing is known beside cells without data and outside") {
  const RasterGrid raster = with_gap(raster_of(8, 8, waves), 4, 4);
  const Vector2d gap = raster.place(4, 4), low = raster.place(0, 0);
  for (const auto interpolation : {CostMapInterpolation::bilinear, CostMapInterpolation::smooth}) {
    const std::shared_ptr<const CostDensity> density = density_of(make_cost_map(raster, interpolation, 2));
    CHECK_FALSE(density->enclose_density({gap - 0.1 * raster.cell, gap}).is_finite());
    CHECK_FALSE(density->enclose_density({low - 0.1 * raster.cell, low}).is_finite());
    CHECK(density->enclose_density({low, low + raster.cell}).is_finite());
    CHECK(move_cost_above(*density, low, low + 0.1 * raster.cell) < kNoWay);
    CHECK(move_cost_above(*density, gap, low) == kNoWay);
    CHECK_FALSE(std::isfinite(density->density(gap)));
  }
  CHECK(density_of(make_cost_map(raster, CostMapInterpolation::bilinear, 3)) == nullptr);
}

namespace {

/// The cheapest of a straight line, random polylines and what a solve makes of the way down the field.
double cheapest_found(const Problem& problem, const AlignedBox2d& box, const Bracket& bracket, Random& random) {
  double least = kNoWay;
  const Vector2d source = problem.source.u, target = problem.target.u;
  for (int k = 0; k < 30; ++k) {
    Eigen::Matrix2Xd x(2, 2 + k % 4);
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(x.cols() - 1);
      x.col(i) = source + t * (target - source) + 0.2 * t * (1 - t) * (place_in(box, random) - box.center());
    }
    least = std::min(least, cost_of(*problem.cost, x));
  }
  if (bracket.way.cols() < 3) return least;
  least = std::min(least, cost_of(*problem.cost, bracket.way));
  const Result solved =
      find_path(problem, WaypointsInitializer(Points(bracket.way.middleCols(1, bracket.way.cols() - 2))), Newton(),
                {.points = 60, .certificate = {.enabled = false}});
  return std::min(least, cost_of(*problem.cost, solved.curve.x));
}

}  // namespace

/// LEASTCOST_BRACKET_RASTERS sets another number of them.
TEST_CASE("raster bracket: never above what a path costs") {
  Random random;
  const int count = rasters_to_try(40);
  std::vector<double> gaps;
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    const RasterGrid raster = random_raster(random);
    const AlignedBox2d box = box_of_values(raster);
    Vector2d source = place_in(box, random), target = place_in(box, random);
    while ((source - target).norm() < 0.3 * box.sizes().norm()) target = place_in(box, random);
    if (k % 5 == 0) source = raster.place(1, 1);  // where four patches meet
    const auto interpolation = k % 3 == 0 ? CostMapInterpolation::bilinear : CostMapInterpolation::smooth;
    const Problem problem = problem_on(make_cost_map(raster, interpolation, 2), box, source, target);
    const std::shared_ptr<const CostDensity> density = density_of(problem.cost);
    const Bracket found = bracket_least_cost(*density, box, source, target, kNoWay, {.cells = 64, .max_cells = 256});
    const double least = cheapest_found(problem, box, found, random);
    REQUIRE(found.lower <= least);
    CHECK(found.upper >= least * (1 - 1e-3));
    gaps.push_back(1 - found.lower / least);
    for (int n = 0; n < 100 && found.potential; ++n) {
      const Vector2d x = place_in(box, random);
      if (!found.potential->is_checked(x)) continue;
      CHECK(found.potential->gradient(x).norm() <= found.potential->ratio() * density->density(x) * (1 + 1e-11));
    }
  }
  std::sort(gaps.begin(), gaps.end());
  CHECK(gaps[gaps.size() / 2] < 0.06);
  if (count > 40)
    WARN("gap: median " << gaps[gaps.size() / 2] << ", 90 % " << gaps[gaps.size() * 9 / 10] << ", largest "
                        << gaps.back());
}

TEST_CASE("raster bracket: a fine map takes as coarse a grid as its formula would") {
  const RasterGrid raster = raster_of(201, 201, [](double x, double y) {
    return 1 + 2 * std::exp(-((x - 100) * (x - 100) + (y - 100) * (y - 100)) / 1100);
  });
  const AlignedBox2d box = box_of_values(raster);
  const Vector2d source = raster.place(95, 15), target = raster.place(105, 185);
  for (const CostMapInterpolation interpolation : {CostMapInterpolation::smooth, CostMapInterpolation::bilinear}) {
    const std::shared_ptr<const CostDensity> density = density_of(make_cost_map(raster, interpolation, 2));
    const Bracket found = bracket_least_cost(*density, box, source, target, kNoWay, {.tolerance = 1e-2});
    CHECK(found.gap() < 1e-2);
    CHECK(found.grid[0] == 128);  // 512 before, and by the bilinear one nothing was proved
  }
}

TEST_CASE("raster bracket: in the plane without bounds, a map is its own box") {
  const RasterGrid raster = raster_of(20, 20, [](double x, double y) { return 1 + 0.1 * x + 0.02 * y; });
  const AlignedBox2d box = box_of_values(raster);
  Problem problem = problem_on(make_cost_map(raster, CostMapInterpolation::smooth, 2), box, box.min() + Vector2d(1, 1),
                               box.max() - Vector2d(1, 1));
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{2, {}});
  FindOptions options;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 1e-2})};
  const Result result = find_path(problem, StraightInitializer(), Newton(), options);
  CHECK(result.certificate.scope == Scope::global);
  CHECK(result.curve.global.value().gap <= 1e-2);
  // Bounds on one side only: the part of the map in them.
  constexpr double kOpen = std::numeric_limits<double>::infinity();
  problem.manifold = std::make_shared<EuclideanManifold>(
      EuclideanManifoldOptions{2, {Eigen::VectorXd(problem.source.u), Eigen::VectorXd::Constant(2, kOpen)}});
  const Result bounded = find_path(problem, StraightInitializer(), Newton(), options);
  CHECK(bounded.certificate.scope == Scope::global);
  CHECK(bounded.curve.global.value().lower_bound >= result.curve.global.value().lower_bound * (1 - 1e-2));
}

TEST_CASE("raster bracket: find_path on a map is global, whichever way it begins") {
  const RasterGrid raster = raster_of(20, 20, [](double x, double y) {
    return 1 + 3 * std::exp(-0.5 * ((x - 4) * (x - 4) + 4 * (y - 4.3) * (y - 4.3)));
  });
  const AlignedBox2d box = box_of_values(raster);
  Points over(2, 1);
  over.col(0) << 4, 5.5;
  const Problem problem =
      problem_on(make_cost_map(raster, CostMapInterpolation::smooth, 2), box, {0, 4.375}, {8, 4.375});
  FindOptions options;
  options.points = 60;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 3e-3})};
  const Result result = find_path(problem, WaypointsInitializer(over), Newton(), options);
  const GlobalBound& bound = result.curve.global.value();
  CHECK(result.certificate.scope == Scope::global);
  CHECK(bound.gap <= 3e-3);
  CHECK(bound.lower_bound <= result.certificate.estimate.value);
}

}  // namespace leastcost::test
