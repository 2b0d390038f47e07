// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/face_obstacle.hpp>
#include <leastcost/problems/obstacles/grid_obstacle.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;
using Obstacles = ObstacleWalls::Obstacles;

Obstacles in_plane() {
  Eigen::MatrixXd corners(6, 2);  // not convex
  corners << -0.9, -0.9, 0.8, -0.9, 0.8, -0.2, 0.1, -0.6, -0.1, 0.7, -0.9, 0.2;
  return {make_ball({.center = Eigen::Vector2d(0.3, 0.5), .radius = 0.4}),
          make_box_obstacle({Eigen::Vector2d(-0.2, -0.5), Eigen::Vector2d(0.9, 0.4)}), make_polygon({corners})};
}

/// A tetrahedron with a dent on one side.
TriangleMesh dented() {
  PolygonSoup soup;
  soup.positions = {Vector3d(-0.8, -0.8, -0.8), Vector3d(0.9, -0.7, -0.6), Vector3d(0, 0.9, -0.7), Vector3d(0, 0, 0.9),
                    Vector3d(0, -0.1, -0.3)};
  const std::vector<std::array<int, 3>> faces = {{0, 4, 1}, {1, 4, 2}, {2, 4, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const std::array<int, 3>& face : faces) {
    soup.polygon_begin.push_back(static_cast<int>(soup.corners.size()));
    for (const int corner : face) soup.corners.push_back(corner);
  }
  soup.polygon_begin.push_back(static_cast<int>(soup.corners.size()));
  soup.source = "dented.obj";
  return TriangleMesh(soup);
}

Obstacles in_space() {
  constexpr int kCount = 21;
  const GridShape shape{Vector3d::Constant(-1), 0.1, {kCount, kCount, kCount}};
  std::vector<double> values;
  for (int k = 0; k < kCount; ++k)
    for (int j = 0; j < kCount; ++j)
      for (int i = 0; i < kCount; ++i) values.push_back(shape.node(i, j, k).norm() - 0.5);
  Obstacles all = {make_ball({.center = Vector3d(0.3, 0.5, 0), .radius = 0.4}),
                   make_box_obstacle({Vector3d(-0.2, -0.5, 0.1), Vector3d(0.9, 0.4, 0.3)}),
                   make_mesh_obstacle(dented(), MeshInside::solid, 0),
                   make_mesh_obstacle(dented(), MeshInside::surface, 0.1),
                   make_grid_obstacle(DistanceGrid(shape, values), 0, "the ball")};
  const Obstacles faces = make_face_obstacles(dented(), 0.05);
  all.insert(all.end(), faces.begin(), faces.end());
  return all;
}

}  // namespace

/// What a bracket rests on where it leaves out what lies within obstacles: a place with the gap -d is at least d from
/// every place outside. GapsAreDistances.
TEST_CASE("obstacle walls: no gap changes by more than the place, and near() tells of all that are negative") {
  Random random;
  for (const Eigen::Index dimension : {2, 3})
    for (const double clearance : {1e-6, 0.2}) {
      CAPTURE(dimension, clearance);
      const Obstacles obstacles = dimension == 2 ? in_plane() : in_space();
      const ObstacleWalls walls(dimension, obstacles, clearance);
      CHECK(find_ability<GapsAreDistances>(walls) != nullptr);
      const auto somewhere = [&](double size) {
        Eigen::VectorXd x(dimension);
        for (double& coordinate : x) coordinate = random.uniform(-size, size);
        return x;
      };
      int within = 0;
      for (int k = 0; k < 2000; ++k) {
        const Eigen::VectorXd x = somewhere(1.2), y = x + somewhere(std::pow(10, -random.uniform(0, 6)));
        CAPTURE(x.transpose(), y.transpose());
        std::vector<Wall> all, others, negative;
        constexpr double kAll = 100;
        walls.near(x, kAll, all);
        walls.near(y, kAll, others);
        walls.near(x, 0, negative);
        REQUIRE(all.size() == obstacles.size());
        REQUIRE(others.size() == obstacles.size());
        for (std::size_t i = 0; i < all.size(); ++i)
          CHECK(std::abs(all[i].gap - others[i].gap) <= (x - y).norm() + 1e-13);
        const auto count = std::ranges::count_if(all, [](const Wall& wall) { return wall.gap < 0; });
        CHECK(std::ssize(negative) == count);
        within += count > 0 ? 1 : 0;
        // Where a move of no length is clear no wall has a negative gap.
        if (walls.clearance(x, x).lower >= 0) CHECK(count == 0);
      }
      CHECK(within > 200);
      CHECK(within < 1900);
    }
}

}  // namespace leastcost::test
