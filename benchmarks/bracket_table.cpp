// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The bracket around the globally least cost (docs/numerics.md Sec. 6.10): gap and CPU seconds per medium, of the
// solve, the bound and the cost of the curve together, for a few tolerances. Where the least cost is known, how far the
// bound lies below it. Then the bracket alone on maps of noise.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <leastcost/framework/find_path.hpp>
#include <leastcost/problems/bracket/bracket.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>

namespace {

using namespace leastcost;
using Eigen::Vector2d;

struct Medium {
  const char *name, *squared;
  Vector2d source, target, lower, upper;
  double cost;         ///< NaN: not known
  double disc_radius;  ///< of an obstacle at the origin; 0: none
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Problem problem_of(const Medium& m) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{
      .dimension = 2, .box = {.lower = Eigen::VectorXd(m.lower), .upper = Eigen::VectorXd(m.upper)}});
  if (m.disc_radius > 0)
    problem.manifold = std::make_shared<FreeSpace>(
        problem.manifold, FreeSpace::Obstacles{make_ball({.center = Vector2d(0, 0), .radius = m.disc_radius})}, 0);
  problem.source.u = m.source;
  problem.target.u = m.target;
  problem.cost = make_metric_field_cost({.field = metric::Formula{{m.squared, "0", m.squared}, {}}}, 2);
  problem.kernel = make_kernel<Expm1Square>();
  return problem;
}

void print_row(const Medium& m, double tolerance) {
  FindOptions options;
  options.points = 100;
  options.certificate.enabled = false;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = tolerance})};
  const Problem problem = problem_of(m);
  const double begin = cpu_seconds();
  const Result result = m.disc_radius > 0 ? find_path(problem, GridInitializer(), Newton(), options)
                                          : find_path(problem, StraightInitializer(), Newton(), options);
  const double seconds = cpu_seconds() - begin;
  const GlobalBound& bound = result.curve.global.value();
  std::printf("%-12s %8.0e  %9.2e %7.2f s  %-8s %5d %9lld  %12.9f", m.name, tolerance, bound.gap, seconds,
              bound.outcome.c_str(), bound.grid ? bound.grid->cells[0] : 0, static_cast<long long>(bound.steps),
              bound.lower_bound);
  if (std::isfinite(m.cost)) std::printf("  %9.2e below", 1 - bound.lower_bound / m.cost);
  std::printf("\n");
  std::fflush(stdout);
}

/// 64 x 64 values, each between 1 and 2 by itself.
RasterGrid noise(unsigned seed) {
  constexpr int kSide = 64;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> value(1, 2);
  RasterGrid raster;
  raster.rows = raster.columns = kSide;
  raster.source = "noise";
  for (int k = 0; k < kSide * kSide; ++k) raster.values.push_back(value(engine));
  return raster;
}

/// From one corner to the opposite one, nearly.
void print_map_row(unsigned seed, double tolerance) {
  const std::shared_ptr<const CostDensity> density =
      density_of(make_cost_map(noise(seed), CostMapInterpolation::smooth, 2));
  const Eigen::AlignedBox2d box(Vector2d(0.5, 0.5), Vector2d(63.5, 63.5));
  const double begin = cpu_seconds();
  const Bracket found = bracket_least_cost(*density, box, {4.14, 6.5}, {59.72, 51.6},
                                           std::numeric_limits<double>::infinity(), {.tolerance = tolerance});
  std::printf("noise %-6u %8.0e  %9.2e %7.2f s  %5d %9ld  %12.6f\n", seed, tolerance, found.gap(),
              cpu_seconds() - begin, found.grid[0], found.cells, found.lower);
  std::fflush(stdout);
}

}  // namespace

int main() {
  const double unknown = std::nan("");
  const std::vector<Medium> media = {
      {"flat", "1", {-1, 0.3}, {1.2, -0.4}, {-2, -2}, {2, 2}, std::hypot(2.2, 0.7), 0},
      {"hill", "(1 + 2 * exp(-x^2 - y^2))^2", {-2, 0}, {2, 0}, {-3, -3}, {3, 3}, 6.030127200428, 0},
      {"hill, one way", "(1 + 2 * exp(-x^2 - y^2))^2", {-2, 0.1}, {2, 0.25}, {-3, -3}, {3, 3}, unknown, 0},
      {"fisheye", "(2 / (1 + x^2 + y^2))^2", {0.5, -0.2}, {-0.7, 0.9}, {-1.6, -1.2}, {1.6, 2}, 2.47561986411056569, 0},
      {"velocity", "1 / (1 + 0.5 * y)^2", {0, 0}, {4, 1}, {-0.5, -0.5}, {4.5, 4.5}, 3.05937323665641694, 0},
      {"half-plane", "1 / y^2", {0, 1}, {2, 3}, {-1.2, 0.3}, {2.8, 4.3}, 1.49099630899480838, 0},
      {"luneburg", "2 - x^2 - y^2", {-0.6, 0}, {0.5, 0.5}, {-0.8, -0.8}, {0.8, 0.8}, unknown, 0},
      // Around a disc of radius 0.6 between (-1.5, 0) and (1.5, 0): two tangents and an arc.
      {"disc",
       "1",
       {-1.5, 0},
       {1.5, 0},
       {-2, -2},
       {2, 2},
       2 * std::sqrt(1.5 * 1.5 - 0.36) + 0.6 * (std::acos(-1.0) - 2 * std::acos(0.4)),
       0.6},
  };
  std::printf("medium       tolerance   gap      CPU       outcome   grid     cells         bound\n");
  for (const double tolerance : {1e-4, 4e-5, 1e-5})
    for (const Medium& m : media) print_row(m, m.disc_radius > 0 ? 10 * tolerance : tolerance);
  std::printf("\nmap          tolerance   gap      CPU       grid     cells         bound\n");
  for (const double tolerance : {5e-3, 1e-3})
    for (const unsigned seed : {11U, 12U, 13U}) print_map_row(seed, tolerance);
  return 0;
}
