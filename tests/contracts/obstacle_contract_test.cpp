// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/obstacle.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/grid_obstacle.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/obstacles/raster_obstacles.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include <leastcost/problems/shapes/height_field.hpp>
#include <leastcost/problems/shapes/point_obstacle.hpp>
#include "catalogue/inputs/planning_scene.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/problems/sample_rasters.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector = Eigen::VectorXd;

constexpr int kTries = 200;

/// What FreeSpace relies on, at random places: distances of segments are the least of those of their points, the way
/// out leads out at the rate of one, and the core lies in its box.
///
/// `found`: how nearly distances of segments are found. A distance that is only nowhere more than the true one
/// (not `exact`) grows by at most one, outside at the rate that it says.
void check_obstacle(const Obstacle& obstacle, double found = 1e-12, bool exact = true) {
  std::mt19937 engine(20261123);
  const Obstacle::Box box = obstacle.core_bounds();
  const Eigen::Index d = box.dim();
  std::uniform_real_distribution<double> place(-3, 3);
  const auto random_point = [&]() -> Vector { return Vector::NullaryExpr(d, [&] { return place(engine); }); };
  Vector away(d), there(d);
  const auto distance = [&](const Vector& x) { return std::max(0.0, obstacle.distance(x, there)); };
  for (int k = 0; k < kTries; ++k) {
    CAPTURE(obstacle.name(), k);
    const Vector a = random_point(), b = random_point();
    double t = -1, sampled = distance(a);
    const double of_segment = obstacle.distance_of_segment(a, b, t);
    constexpr int kSamples = 1000;
    for (int i = 0; i <= kSamples; ++i) sampled = std::min(sampled, distance(a + (b - a) * i / kSamples));
    CHECK(of_segment <= sampled + 1e-12);
    CHECK(of_segment >= sampled - (b - a).norm() / kSamples);
    REQUIRE((t >= 0 && t <= 1));
    CHECK(std::abs(distance(a + t * (b - a)) - of_segment) <= found);

    constexpr double kStep = 1e-6;
    const double here = obstacle.distance(a, away);
    const double rate = exact ? 1 : away.norm();
    CHECK(away.norm() == Approx(rate));
    CHECK(rate <= 1 + 1e-12);
    const double ahead = obstacle.distance(a + kStep * away, there);
    if (exact || here > 0)
      CHECK(ahead == Approx(here + kStep * rate * rate).margin(1e-9));
    else  // within, what is not exact may end at a depth
      CHECK(ahead >= here - 1e-9);
    CHECK(here <= box.exteriorDistance(a) + (box.max() - box.min()).norm());
    if (here <= 0) CHECK(box.contains(a));
  }
  CHECK(obstacle.radius() >= 0);
  CHECK(!obstacle.name().empty());
}

}  // namespace

TEST_CASE("obstacle contract: map") {
  OccupancyGrid grid;
  grid.rows = grid.columns = 4;
  grid.blocked.assign(16, false);
  for (const auto& [row, column] : {std::pair{0, 0}, {1, 1}, {1, 2}, {2, 2}})
    grid.blocked[grid.index(row, column)] = true;
  grid.cell = 0.5;
  const auto all = map_obstacles(grid);
  CHECK(all.size() == 3);  // the corner, a row and a column that share a cell
  for (const auto& obstacle : all) check_obstacle(*obstacle);
}

TEST_CASE("obstacle contract: raster") {
  RasterGrid raster = test::with_gap(test::raster_of(8, 8, [](double, double) { return 1.0; }), 2, 3);
  raster.corner << -2, -1;
  raster.values[raster.index(7, 7)] = 5;
  RasterObstacleOptions options;
  options.above = 4;
  const auto all = make_raster_obstacles(raster, options);
  REQUIRE(all.size() == 2);
  for (const auto& obstacle : all) check_obstacle(*obstacle);
  // Without data at (2, 3) there are none from the middles of the cells two before to those two behind it.
  const Obstacle::Box gap = all[0]->core_bounds(), above = all[1]->core_bounds();
  CHECK(gap.min() == raster.place(0, 1));
  CHECK(gap.max() == raster.place(4, 5));
  CHECK(above.min() == Vector2d(1.5, 0.75));
  CHECK(above.max() == Vector2d(2, 1));
  raster.values[raster.index(2, 3)] = 1;
  CHECK_THROWS_AS(make_raster_obstacles(raster, {}), InputError);
}
TEST_CASE("obstacle contract: ball") {
  check_obstacle(*make_ball({Vector2d(0.3, -0.2), 0.5}));
  check_obstacle(*make_ball({Vector3d(0.3, -0.2, 0.1), 0.5}));
}

TEST_CASE("obstacle contract: box") {
  check_obstacle(*make_box_obstacle({Vector2d(-1, -0.5), Vector2d(0.5, 1)}));
  check_obstacle(*make_box_obstacle({Vector3d(-1, -0.5, 0), Vector3d(0.5, 1, 0.2)}));
}

TEST_CASE("obstacle contract: box, turned") {
  check_obstacle(*make_box({.size = Vector2d(1, 2), .pose = {.position = Vector2d(0.3, 1), .angle = 0.7}}));
  check_obstacle(
      *make_box({.size = Vector3d(1, 2, 0.5), .pose = {.position = Vector3d(0.3, 1, 0), .rpy = Vector3d(0.5, -1, 2)}}));
}

TEST_CASE("obstacle contract: capsule") {
  check_obstacle(*make_capsule({Vector2d(-1, 0.5), Vector2d(1, 0.7), 0.2}));
  check_obstacle(*make_capsule({Vector3d(-1, 0.5, 0), Vector3d(1, 0.7, 1), 0.2}));
}

TEST_CASE("obstacle contract: cylinder") {
  check_obstacle(*make_cylinder({0.6, 1.5, {.position = Vector3d(0.2, 0.4, -0.1), .rpy = Vector3d(0.3, 0.9, 0)}}));
}

TEST_CASE("obstacle contract: cone") {
  check_obstacle(*make_cone({0.9, 1.5, 0, {.rpy = Vector3d(0.3, 0.9, 0)}}));
  check_obstacle(*make_cone({0.9, 1.5, 0.3, {.rotation = Vector3d(0.3, 0.9, 0)}}));
  check_obstacle(*make_cone({0.2, 1, 0.8, {.quaternion = Eigen::Vector4d(1, 1, 0, 0)}}));  // wider at its top
}

TEST_CASE("obstacle contract: half_space") {
  check_obstacle(*make_half_space({Vector2d(1, 2), 0.3}));
  check_obstacle(*make_half_space({Vector3d(1, -2, 0.5), -0.3}));
}

TEST_CASE("obstacle contract: height_field") {
  RasterGrid raster = test::raster_of(7, 6, [](double x, double y) { return 0.4 * std::sin(3 * x) - 0.3 * y; });
  raster.corner << -1.5, -0.9;
  HeightFieldOptions options;
  options.depth = 0.8;
  options.pose.rpy = Vector3d(0.2, -0.3, 1);
  check_obstacle(*make_height_field(raster, options));
}

TEST_CASE("obstacle contract: points") {
  check_obstacle(*make_point_obstacle(test::sphere(2).positions, 0.1, "the points"));
}

/// Its objects are obstacles of the kinds above, in places and with names of their own.
TEST_CASE("obstacle contract: scene") {
  PlanningSceneOptions options;
  options.file = "configs/data/shelf.yaml";
  const auto all = read_planning_scene(options, test::project_dir(), {});
  REQUIRE(all.size() == 7);
  CHECK(all[0]->name() == "the box 'board_low'");
  CHECK(all[6]->name() == "the cylinder 'can'");
  for (const auto& obstacle : all) check_obstacle(*obstacle);
}

TEST_CASE("obstacle contract: polygon") {
  Eigen::MatrixXd corners(5, 2);
  corners << 0, 0, 2, 0.3, 1, 1, 1.5, 2, -0.2, 1.4;
  check_obstacle(*make_polygon({corners}));
  check_obstacle(*make_polygon({corners.colwise().reverse()}));  // the other way round is the same polygon
}

TEST_CASE("obstacle contract: mesh") {
  check_obstacle(*make_mesh_obstacle(TriangleMesh(test::sphere(3)), MeshInside::solid, 0.1));
  check_obstacle(*make_mesh_obstacle(TriangleMesh(test::sheet(6, 6,
                                                              [](double s, double t) -> Vector3d {
                                                                return {2 * s - 1, 2 * t - 1, 0.3 * std::sin(4 * s)};
                                                              })),
                                     MeshInside::surface, 0.1));
}

/// Of a ball of radius 0.6, whose centre is no node.
TEST_CASE("obstacle contract: distance_grid") {
  const GridShape shape{Vector3d(-1.05, -1.1, -1), 0.1, {22, 22, 21}};
  std::vector<double> values;
  for (int k = 0; k < shape.count[2]; ++k)
    for (int j = 0; j < shape.count[1]; ++j)
      for (int i = 0; i < shape.count[0]; ++i)
        values.push_back((shape.node(i, j, k) - Vector3d(0.03, 0, -0.02)).norm() - 0.6);
  check_obstacle(*make_grid_obstacle(DistanceGrid(shape, values), 0.1, "the ball"), 1e-9, false);
}

}  // namespace leastcost
