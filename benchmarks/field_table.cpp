// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Fields of least costs in random worlds of each kind, against a field on a lattice eight times as fine: the largest
// difference, and whether the error that the coarse field states covers it. Constant winds are compared with their
// closed form, spheres with great circles, tori with exact distances on a fine mesh, fields in space and media on
// closed charts with one on a lattice four times as fine. Odd seeds were used while the methods were developed, even
// ones were kept aside.
//   field_table [FIRST_SEED] [SEED_STEP] [WORLDS] [KIND]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/fields/cost_field.hpp>
#include <leastcost/problems/fields/space_field.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "problems/mesh/surface_path.hpp"

namespace {

using namespace leastcost;
using Eigen::Vector2d;

constexpr int kCells = 40, kFiner = 8;  ///< along a side of the unit box; of the reference

std::shared_ptr<const ConstraintManifold> unit_box(int dimension) {
  return std::make_shared<const EuclideanManifold>(
      EuclideanManifoldOptions{dimension, {Eigen::VectorXd::Zero(dimension), Eigen::VectorXd::Ones(dimension)}});
}

struct World {
  Problem problem;
  Vector2d source;
  std::function<double(const Vector2d&)> truth;  ///< empty: a finer field
  double resolution = 1.0 / kCells;
  int finer = kFiner;
};

using Eigen::Vector3d;

Vector3d on_sphere(const Vector2d& u) {
  return {std::cos(u[1]) * std::cos(u[0]), std::cos(u[1]) * std::sin(u[0]), std::sin(u[1])};
}

/// Exact distances on a fine mesh of a torus, whose vertices are on a lattice of its angles.
class TorusMesh {
 public:
  static constexpr std::int32_t kAround = 240, kTube = 120;
  TorusMesh(const ConstraintManifold& torus, const Vector2d& source) {
    PolygonSoup soup;
    const auto corner = [](std::int32_t a, std::int32_t b) { return a % kAround * kTube + b % kTube; };
    for (std::int32_t i = 0; i < kAround; ++i)
      for (std::int32_t j = 0; j < kTube; ++j) {
        soup.positions.emplace_back(positions(torus, {at(i, j), {}, true}).col(0));
        for (const std::int32_t v : {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j),
                                     corner(i + 1, j + 1), corner(i, j + 1)})
          soup.corners.push_back(v);
      }
    for (std::int32_t k = 0; k <= static_cast<std::int32_t>(soup.corners.size()); k += 3)
      soup.polygon_begin.push_back(k);
    const TriangleMesh mesh(soup);
    const ExactSearch search(mesh);
    ExactSearch::Workspace workspace(search);
    const auto v = static_cast<std::int32_t>(number(source));
    distances_ =
        search.distances(point_on_face(mesh, mesh.faces_of_vertex(v)[0], mesh.position(v)), workspace).distance;
  }
  static Vector2d at(std::int32_t i, std::int32_t j) {
    return {-M_PI + 2 * M_PI * i / kAround, -M_PI + 2 * M_PI * j / kTube};
  }
  double operator()(const Vector2d& u) const { return distances_[number(u)]; }

 private:
  static std::size_t number(const Vector2d& u) {
    const auto step = [](double angle, std::int32_t count) {
      return static_cast<std::int32_t>(std::lround((angle + M_PI) / (2 * M_PI) * count)) % count;
    };
    return static_cast<std::size_t>(step(u[0], kAround) * kTube + step(u[1], kTube));
  }
  std::vector<double> distances_;
};

class Maker {
 public:
  explicit Maker(std::uint32_t seed) : random_(seed) {}

  World raster() {
    RasterGrid grid = smooth_raster(1, 4);
    return on_plane(make_cost_map(grid, CostMapInterpolation::bilinear, 2), {});
  }
  World obstacles() { return on_plane(make_euclidean_cost(2), discs()); }
  World media() {
    const bool jump = chance(0.3);
    std::string n = "1";
    for (int k = 0; k < 3; ++k) {
      const Vector2d at = place();
      const std::string r2 = "((x - " + text(at[0]) + ")^2 + (y - " + text(at[1]) + ")^2)";
      n += jump ? " + " + text(number(0.2, 1)) + " * (1 + tanh(40 * (" + text(number(0.01, 0.06)) + " - " + r2 + ")))"
                : " + " + text(number(0.2, 1.5)) + " * exp(-" + r2 + " / " + text(number(0.02, 0.1)) + ")";
    }
    return on_plane(make_refractive_index_cost({refraction::Formula{n, {}}}, 2), chance(0.3) ? discs() : none());
  }
  World wind() {
    const double strength = number(0.2, 0.95), turn = number(-M_PI, M_PI);
    const Vector2d w = strength * Vector2d(std::cos(turn), std::sin(turn));
    if (chance(0.5)) {
      World world = on_plane(make_zermelo_cost({.speed = "1", .flow = flow::Formula{{text(w[0]), text(w[1])}}}, 2), {});
      const auto cost = world.problem.cost;
      const Vector2d source = world.source;
      world.truth = [cost, source](const Vector2d& x) { return x == source ? 0 : move_cost(*cost, source, x); };
      return world;
    }
    // A vortex beside a stream, nowhere faster than `strength`.
    const Vector2d at = place();
    const std::string x = "(x - " + text(at[0]) + ")", y = "(y - " + text(at[1]) + ")";
    const std::string swirl = text(number(-1, 1) * strength) + " * exp(-(" + x + "^2 + " + y + "^2) / 0.1) / 0.5";
    return on_plane(make_zermelo_cost({.speed = "1",
                                       .flow = flow::Formula{{text(0.6 * w[0]) + " - " + y + " * " + swirl,
                                                              text(0.6 * w[1]) + " + " + x + " * " + swirl}}},
                                      2),
                    chance(0.3) ? discs() : none());
  }
  World terrain() { return on_terrain(make_euclidean_cost(3)); }
  World walking() { return on_terrain(make_walking_cost({}, 3)); }
  World sphere() {
    const Vector2d source(number(-M_PI, M_PI), std::asin(number(-0.99, 0.99)));
    World world = closed(parametric::Sphere{}, source);
    world.truth = [from = on_sphere(source)](const Vector2d& u) {
      const Vector3d to = on_sphere(u);
      return std::atan2(from.cross(to).norm(), from.dot(to));
    };
    return world;
  }
  World torus() {
    const Vector2d source = TorusMesh::at(int(number(0, TorusMesh::kAround - 1)), int(number(0, TorusMesh::kTube - 1)));
    World world = closed(parametric::Torus{2, 1}, source);
    world.resolution = 2 * M_PI / (TorusMesh::kTube / 2);
    world.truth = TorusMesh(*world.problem.manifold, source);
    return world;
  }
  /// A medium on a sphere, a torus, a Klein bottle or a Moebius strip.
  World closed_media() {
    std::string n = "1";
    for (int k = 0; k < 3; ++k) {
      n += " + " + text(number(0.2, 1.5)) + " * exp(-(";
      for (const char* axis : {"x", "y", "z"}) n += std::string("(") + axis + " - " + text(number(-2, 2)) + ")^2 + ";
      n += "0) / " + text(number(0.2, 1)) + ")";
    }
    const std::array<parametric::Surface, 4> surfaces = {parametric::Sphere{}, parametric::Torus{2, 1},
                                                         parametric::KleinBottle{2, 1}, parametric::MoebiusStrip{0.5}};
    const auto which = std::size_t(number(0, 3.999));
    const double high = which == 0 ? 1.4 : which == 3 ? 0.45 : M_PI;
    World world = closed(surfaces[which], {number(-1.5, 1.5), number(-high, high)});
    world.problem.cost = make_refractive_index_cost({refraction::Formula{n, {}}}, 3);
    world.finer = 4;
    return world;
  }

 private:
  static std::string text(double value) { return "(" + std::to_string(value) + ")"; }
  static FreeSpace::Obstacles none() { return {}; }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance(double p) { return number(0, 1) < p; }
  Vector2d place() { return {number(0.05, 0.95), number(0.05, 0.95)}; }

  FreeSpace::Obstacles discs() {
    constexpr double kApart = 0.1;
    FreeSpace::Obstacles all;
    for (int trial = 0; trial < 50 && all.size() < 4; ++trial) {
      const double radius = number(0.05, 0.15), edge = radius + kApart;
      const Vector2d middle(number(edge, 1 - edge), number(edge, 1 - edge));
      const bool apart = std::all_of(taken_.begin(), taken_.end(), [&](const auto& other) {
        return (other.first - middle).norm() > other.second + radius + kApart;
      });
      if (!apart) continue;
      taken_.emplace_back(middle, radius);
      all.push_back(make_ball({middle, radius}));
    }
    return all;
  }

  World closed(const parametric::Surface& surface, const Vector2d& source) {
    World world = of(make_parametric_manifold({surface, {}}), make_euclidean_cost(3), source);
    world.resolution = 2 * M_PI / 60;
    return world;
  }

  /// Sums of waves, over a unit box with a value at every node of the coarse lattice.
  RasterGrid smooth_raster(double low, double high) {
    RasterGrid grid;
    grid.rows = grid.columns = kCells + 1;
    grid.cell = Vector2d::Constant(1.0 / kCells);
    grid.corner = -grid.cell / 2;
    grid.source = "random";
    grid.values.assign(std::size_t(grid.rows) * std::size_t(grid.columns), 0);
    for (int wave = 0; wave < 5; ++wave) {
      const double kx = number(-14, 14), ky = number(-14, 14), phase = number(0, 6.3);
      for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
          grid.values[grid.index(row, column)] += std::sin((kx * column + ky * row) / kCells + phase);
    }
    const auto [least, most] = std::minmax_element(grid.values.begin(), grid.values.end());
    const double from = *least, by = (high - low) / (*most - *least);
    for (double& value : grid.values) value = low + by * (value - from);
    return grid;
  }

  World on_plane(std::shared_ptr<const SegmentCost> cost, const FreeSpace::Obstacles& obstacles) {
    Vector2d source = place();
    const auto inside = [&] {
      return std::any_of(taken_.begin(), taken_.end(),
                         [&](const auto& disc) { return (disc.first - source).norm() < disc.second + 0.05; });
    };
    while (inside()) source = place();
    std::shared_ptr<const ConstraintManifold> domain = unit_box(2);
    if (!obstacles.empty()) domain = std::make_shared<const FreeSpace>(domain, obstacles, 0.0);
    return of(domain, std::move(cost), source);
  }
  World on_terrain(std::shared_ptr<const SegmentCost> cost) {
    const double high = number(0.05, 0.3);
    return of(std::make_shared<const TerrainManifold>(smooth_raster(0, high)), std::move(cost), place());
  }
  World of(std::shared_ptr<const ConstraintManifold> domain, std::shared_ptr<const SegmentCost> cost,
           const Vector2d& source) {
    World world;
    world.problem.manifold = std::move(domain);
    world.problem.cost = std::move(cost);
    world.problem.source.u = source;
    world.problem.target.u = source + Vector2d(1e-3, 0);
    world.source = source;
    return world;
  }

  std::mt19937 random_;
  std::vector<std::pair<Vector2d, double>> taken_;
};

struct Result {
  double worst = 0, stated = 0, largest = 0, seconds = 0;
  std::string method;
};

/// Balls, and in half of the worlds a medium, in the unit cube.
Result measured_in_space(std::uint32_t seed) {
  constexpr int kCellsInSpace = 24, kFinerInSpace = 4;
  constexpr double kApart = 0.13, step = 1.0 / kCellsInSpace;
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto text = [](double value) { return "(" + std::to_string(value) + ")"; };
  using Eigen::Vector3d;
  const Vector3d source(number(0.05, 0.95), number(0.05, 0.95), number(0.05, 0.95));
  std::shared_ptr<const ConstraintManifold> domain = unit_box(3);
  FreeSpace::Obstacles balls;
  std::vector<std::pair<Vector3d, double>> taken = {{source, 0.0}};
  for (int trial = 0; trial < 50 && balls.size() < 4 && seed % 3 != 0; ++trial) {
    const double radius = number(0.08, 0.2), edge = radius + kApart;
    const Vector3d middle(number(edge, 1 - edge), number(edge, 1 - edge), number(edge, 1 - edge));
    if (std::any_of(taken.begin(), taken.end(),
                    [&](const auto& other) { return (other.first - middle).norm() < other.second + radius + kApart; }))
      continue;
    taken.emplace_back(middle, radius);
    balls.push_back(make_ball({middle, radius}));
  }
  if (!balls.empty()) domain = std::make_shared<const FreeSpace>(domain, balls, 0.0);
  std::string n = "1";
  for (int k = 0; k < 3; ++k) {
    n += " + " + text(number(0.2, 1.5)) + " * exp(-(";
    for (const char* axis : {"x", "y", "z"}) n += std::string("(") + axis + " - " + text(number(0, 1)) + ")^2 + ";
    n += "0) / " + text(number(0.05, 0.15)) + ")";
  }
  Problem problem;
  problem.manifold = domain;
  problem.cost =
      number(0, 1) < 0.3 ? make_euclidean_cost(3) : make_refractive_index_cost({refraction::Formula{n, {}}}, 3);
  problem.source.u = source;
  problem.target.u = source + Vector3d(1e-3, 0, 0);
  const std::clock_t begin = std::clock();
  const SpaceField coarse = space_costs_from(problem, {source}, {.resolution = step});
  Result result{0, coarse.error, 0, double(std::clock() - begin) / CLOCKS_PER_SEC, "isotropic march"};
  const SpaceField fine =
      space_costs_from(problem, {source}, {.resolution = step / kFinerInSpace, .estimate_error = false});
  for (std::int32_t k = 0; k < coarse.count[2]; ++k)
    for (std::int32_t j = 0; j < coarse.count[1]; ++j)
      for (std::int32_t i = 0; i < coarse.count[0]; ++i) {
        const double value = coarse.value(i, j, k);
        if (!std::isfinite(value)) continue;
        const double right = fine.value(kFinerInSpace * i, kFinerInSpace * j, kFinerInSpace * k);
        result.worst = std::max(result.worst, std::abs(value - right));
        result.largest = std::max(result.largest, right);
      }
  return result;
}

Result measured(const World& world) {
  const double step = world.resolution;
  const std::clock_t begin = std::clock();
  const CostField coarse = costs_from(world.problem, {world.source}, {.resolution = step});
  Result result{0, coarse.error, 0, double(std::clock() - begin) / CLOCKS_PER_SEC, coarse.method};
  CostField fine;
  if (!world.truth)
    fine = costs_from(world.problem, {world.source}, {.resolution = step / world.finer, .estimate_error = false});
  for (std::int32_t j = 0; j < coarse.count[1]; ++j)
    for (std::int32_t i = 0; i < coarse.count[0]; ++i) {
      const double value = coarse.value(i, j);
      if (!std::isfinite(value)) continue;
      const Vector2d node = coarse.node(i, j);
      const bool common = !world.truth && fine.count[0] == world.finer * (coarse.count[0] - 1) + 1 &&
                          fine.count[1] == world.finer * (coarse.count[1] - 1) + 1;
      const double right = world.truth ? world.truth(node)
                           : common    ? fine.value(world.finer * i, world.finer * j)
                                       : value_at(fine, node);
      result.worst = std::max(result.worst, std::abs(value - right));
      result.largest = std::max(result.largest, right);
    }
  return result;
}

struct Kind {
  const char* name;
  World (Maker::*make)();
};

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int k, int otherwise) { return argc > k ? std::atoi(argv[k]) : otherwise; };
  const int first = number(1, 2), by = number(2, 2), worlds = number(3, 100);
  const std::string only = argc > 4 ? argv[4] : "";
  std::printf("%-10s %-16s %8s %9s %22s %22s %18s %8s\n", "kind", "method", "worlds", "covered", "error/largest: med.",
              "worst", "error/stated worst", "ms");
  for (const Kind& kind :
       {Kind{"raster", &Maker::raster}, Kind{"obstacles", &Maker::obstacles}, Kind{"media", &Maker::media},
        Kind{"terrain", &Maker::terrain}, Kind{"walking", &Maker::walking}, Kind{"wind", &Maker::wind},
        Kind{"sphere", &Maker::sphere}, Kind{"torus", &Maker::torus}, Kind{"closed", &Maker::closed_media},
        Kind{"space", nullptr}}) {
    if (!only.empty() && only != kind.name) continue;
    std::vector<double> errors;
    int covered = 0;
    double worst_share = 0, seconds = 0;
    std::string method;
    for (int k = 0; k < worlds; ++k) {
      const auto seed = static_cast<std::uint32_t>(first + by * k);
      Maker maker(seed);
      const Result result = kind.make == nullptr ? measured_in_space(seed) : measured((maker.*kind.make)());
      errors.push_back(result.worst / result.largest);
      if (result.worst <= result.stated)
        ++covered;
      else if (std::getenv("FIELD_TABLE_VERBOSE") != nullptr)
        std::printf("  seed %d: error %.3g stated %.3g largest %.3g\n", first + by * k, result.worst, result.stated,
                    result.largest);
      worst_share = std::max(worst_share, result.worst / result.stated);
      seconds += result.seconds;
      method = result.method;
    }
    std::sort(errors.begin(), errors.end());
    std::fflush(stdout);
    std::printf("%-10s %-16s %8d %9d %22.2e %22.2e %18.2f %8.1f\n", kind.name, method.c_str(), worlds, covered,
                errors[errors.size() / 2], errors.back(), worst_share, 1000 * seconds / worlds);
  }
}
