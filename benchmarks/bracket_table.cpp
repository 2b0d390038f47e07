// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The bracket around the globally least cost (docs/numerics.md Sec. 6.10): gap and CPU seconds per medium, of the
// solve, the bound and the cost of the curve together, for a few tolerances. Where the least cost is known, how far the
// bound lies below it. Then the bracket alone on maps of noise, and the same table for media in space.
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

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/bracket/search/bracket.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
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

template <class AnyMedium>
void print_row(const AnyMedium& m, double tolerance, const Initializer& first) {
  FindOptions options;
  options.points = 100;
  options.certificate.enabled = false;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = tolerance})};
  const Problem problem = problem_of(m);
  const double begin = cpu_seconds();
  const Result result = find_path(problem, first, Newton(), options);
  const double seconds = cpu_seconds() - begin;
  const GlobalBound& bound = result.curve.global.value();
  std::printf("%-12s %8.0e  %9.2e %7.2f s  %-8s %5d %9lld  %12.9f", m.name, tolerance, bound.gap, seconds,
              word_of(bound.outcome).data(), bound.grid ? bound.grid->cells[0] : 0, static_cast<long long>(bound.steps),
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

struct SpaceMedium {
  const char *name, *density;
  Eigen::Vector3d source, target, lower, upper;
  double cost;         ///< NaN: not known
  double ball_radius;  ///< of an obstacle at the origin; 0: none
};

Problem problem_of(const SpaceMedium& m) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{
      .dimension = 3, .box = {.lower = Eigen::VectorXd(m.lower), .upper = Eigen::VectorXd(m.upper)}});
  if (m.ball_radius > 0)
    problem.manifold = std::make_shared<FreeSpace>(
        problem.manifold,
        FreeSpace::Obstacles{make_ball({.center = Eigen::VectorXd::Zero(3), .radius = m.ball_radius})}, 0);
  problem.source.u = m.source;
  problem.target.u = m.target;
  problem.cost = make_refractive_index_cost({.index = refraction::Formula{m.density, {}}}, 3);
  problem.kernel = make_kernel<Expm1Square>();
  return problem;
}

/// Developed on: flat, hill, fisheye, half-space, velocity and ball. The others were not looked at before.
std::vector<SpaceMedium> media_in_space() {
  const double unknown = std::nan(""), pi = std::acos(-1.0);
  return {
      {"flat", "1", {-1, .3, .1}, {1.2, -.4, -.3}, {-1.6, -1.6, -1.6}, {1.6, 1.6, 1.6}, std::sqrt(5.49), 0},
      {"hill",
       "1 + 2 * exp(-x^2 - y^2 - z^2)",
       {-2, 0, 0},
       {2, 0, 0},
       {-2.6, -2.6, -2.6},
       {2.6, 2.6, 2.6},
       6.030127200428,
       0},
      {"fisheye",
       "2 / (1 + x^2 + y^2 + z^2)",
       {.5, -.2, .1},
       {-.7, .9, -.2},
       {-1.4, -1, -1.4},
       {1.4, 1.8, 1.4},
       2 * std::asin(std::sqrt(2.74 / (1.3 * 2.34))),
       0},
      {"half-space", "1 / z", {0, .1, 1}, {1.6, 1.3, 3}, {-1, -1.2, .4}, {2.6, 2.4, 4}, std::acosh(1 + 8.0 / 6), 0},
      {"velocity",
       "1 / (1 + 0.5 * z)",
       {0, 0, 0},
       {3.2, 2.4, 1},
       {-.5, -.5, -.5},
       {4.5, 4.5, 4.5},
       3.05937323665641694,
       0},
      {"fisheye 2",
       "2 / (1 + x^2 + y^2 + z^2)",
       {.9, .3, -.4},
       {-.6, -.5, .7},
       {-1.5, -1.5, -1.5},
       {1.5, 1.5, 1.5},
       2 * std::asin(std::sqrt(4.1 / (2.06 * 2.1))),
       0},
      {"half-space 2", "1 / z", {0, 0, .8}, {.9, -1.2, 1.2}, {-1, -2, .3}, {2, 1, 3}, std::acosh(1 + 2.41 / 1.92), 0},
      {"hill aside",
       "1 + exp(-2 * x^2 - 2 * (y - 0.2)^2 - 2 * (z + 0.1)^2)",
       {-1.5, .1, 0},
       {1.5, 0, .2},
       {-2, -2, -2},
       {2, 2, 2},
       unknown,
       0},
      {"two hills",
       "1 + exp(-2 * (x + 0.7)^2 - 2 * (y - 0.3)^2 - 2 * z^2) + exp(-2 * (x - 0.7)^2 - 2 * (y + 0.3)^2 - "
       "2 * z^2)",
       {-1.8, 0, 0},
       {1.8, 0, .1},
       {-2.4, -2, -2},
       {2.4, 2, 2},
       unknown,
       0},
      {"ball", "1", {-2, 0, 0}, {2, 0, 0}, {-2.6, -1.8, -1.8}, {2.6, 1.8, 1.8}, 2 * std::sqrt(3.0) + pi / 3, 1},
      {"ball aside", "1", {-1.5, .2, 0}, {1.5, .1, .1}, {-2, -1.5, -1.5}, {2, 1.5, 1.5}, unknown, .6},
  };
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
    for (const Medium& m : media)
      if (m.disc_radius > 0)
        print_row(m, 10 * tolerance, GridInitializer());
      else
        print_row(m, tolerance, StraightInitializer());
  std::printf("\nmap          tolerance   gap      CPU       grid     cells         bound\n");
  for (const double tolerance : {5e-3, 1e-3})
    for (const unsigned seed : {11U, 12U, 13U}) print_map_row(seed, tolerance);
  std::printf("\nin space     tolerance   gap      CPU       outcome   grid     cells         bound\n");
  for (const SpaceMedium& m : media_in_space())
    if (m.ball_radius > 0)
      print_row(m, 1.5e-2, WaypointsInitializer(Points(Eigen::Vector3d(0, 0, 1.3 * m.ball_radius))));
    else
      print_row(m, 3e-3, StraightInitializer());
  return 0;
}
