// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>

#include <cmath>
#include <fstream>
#include <random>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Vector = Eigen::VectorXd;

/// The box from (-1, -1, -1) to (1, 1, 1), by 8 corners and 12 triangles; `faces` of them.
PolygonSoup box_mesh(int faces = 12) {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
  const int corners[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (int f = 0; f < faces; ++f) {
    soup.polygon_begin.push_back(3 * f);
    for (const int corner : corners[f]) soup.corners.push_back(corner);
  }
  soup.polygon_begin.push_back(3 * faces);
  soup.source = "cube.obj";
  return soup;
}

}  // namespace

TEST_CASE("mesh obstacles: a cube of triangles is the box") {
  const auto mesh = make_mesh_obstacle(TriangleMesh(box_mesh()), MeshInside::solid, 0);
  const auto box = make_box_obstacle({Vector3d(-1, -1, -1), Vector3d(1, 1, 1)});
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> place(-2, 2);
  const auto random_point = [&]() -> Vector { return Vector3d(place(engine), place(engine), place(engine)); };
  for (int k = 0; k < 2000; ++k) {
    const Vector a = random_point(), b = random_point();
    CAPTURE(k, a.transpose(), b.transpose());
    Vector away(3), expected(3);
    CHECK(mesh->distance(a, away) == Approx(box->distance(a, expected)).margin(1e-13));
    CHECK((away - expected).norm() < 1e-9);
    double t = -1, u = -1;
    const double distance = mesh->distance_of_segment(a, b, t), truth = box->distance_of_segment(a, b, u);
    CHECK(distance == Approx(truth).margin(1e-13));
    if (truth == 0) CHECK(t == Approx(u).margin(1e-12));
  }
}

TEST_CASE("mesh obstacles: a surface lets a path be within it, an open mesh has no inside") {
  const auto room = make_mesh_obstacle(TriangleMesh(box_mesh()), MeshInside::surface, 0.1);
  Vector away(3);
  CHECK(room->distance(Vector3d(0.2, 0, 0), away) == Approx(0.8));
  CHECK(away.isApprox(Vector(Vector3d(-1, 0, 0))));
  double t = 0;
  CHECK(room->distance_of_segment(Vector3d(-0.5, 0, 0), Vector3d(0.7, 0, 0), t) == Approx(0.3));
  CHECK(room->distance_of_segment(Vector3d(-0.5, 0, 0), Vector3d(1.5, 0, 0), t) == 0);
  CHECK(t == Approx(0.75));
  const auto open = make_mesh_obstacle(TriangleMesh(box_mesh(10)), MeshInside::closed, 0);
  CHECK(open->distance(Vector3d(0, 0, 0), away) == Approx(1));
  CHECK(make_mesh_obstacle(TriangleMesh(box_mesh()), MeshInside::closed, 0)->distance(Vector3d(0, 0, 0), away) ==
        Approx(-1));
  CHECK_THROWS_WITH(make_mesh_obstacle(TriangleMesh(box_mesh(10)), MeshInside::solid, 0),
                    Catch::Contains("it is open, with 4 border edges") && Catch::Contains("`weld: true`"));
}

TEST_CASE("mesh obstacles: scaled, turned, moved, from a file, faults have names") {
  const test::ScratchDir folder;
  std::ofstream(folder.path() / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  MeshObstacleOptions options;
  options.file = "a.obj";
  options.scale = 2;
  options.rotation = Vector3d(0, 0, std::acos(-1) / 2);
  options.translation = Vector3d(10, 0, 1);
  const auto box = make_mesh_obstacle(options, folder.path())->core_bounds();
  CHECK(Vector3d(box.min()).isApprox(Vector3d(8, 0, 1), 1e-12));
  CHECK(Vector3d(box.max()).isApprox(Vector3d(10, 2, 1), 1e-12));
  options.scale = 0;
  CHECK_THROWS_AS(make_mesh_obstacle(options, folder.path()), OptionError);
  options.scale = 1;
  options.rotation = Eigen::Vector2d(0, 1);
  CHECK_THROWS_WITH(make_mesh_obstacle(options, folder.path()), Catch::Contains("three numbers"));
}

TEST_CASE("mesh obstacles: thin and degenerate triangles against points of them") {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> place(-1, 1);
  PolygonSoup soup;
  for (int i = 0; i < 60; ++i) {
    Vector3d p(place(engine), place(engine), place(engine));
    if (i % 3 == 2 && i % 2 == 0) p = soup.positions.back() + 1e-7 * p;  // a needle
    soup.positions.push_back(p);
  }
  for (int f = 0; f < 20; ++f) {
    soup.polygon_begin.push_back(3 * f);
    for (int k = 0; k < 3; ++k) soup.corners.push_back(3 * f + k);
  }
  soup.polygon_begin.push_back(60);
  const auto obstacle = make_mesh_obstacle(TriangleMesh(soup), MeshInside::closed, 0);
  Vector away(3);
  for (int k = 0; k < 200; ++k) {
    const Vector3d a(place(engine), place(engine), place(engine)), b(place(engine), place(engine), place(engine));
    double t = 0, sampled = 10;
    const double found = obstacle->distance_of_segment(a, b, t);
    for (int i = 0; i <= 1000; ++i)
      sampled = std::min(sampled, obstacle->distance(Vector3d(a + (b - a) * i / 1000), away));
    CAPTURE(k, found, sampled);
    CHECK(found <= sampled + 1e-12);
    CHECK(found >= sampled - (b - a).norm() / 1000);
    CHECK(obstacle->distance(Vector3d(a + t * (b - a)), away) == Approx(found).margin(1e-12));
  }
}

}  // namespace leastcost
