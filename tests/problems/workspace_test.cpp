// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/robot_workspace.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include "problems/drawing/solids.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// By the divergence theorem; of a closed surface whose triangles are counterclockwise from outside.
double volume(const TriangleSoup& surface) {
  double six = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto at = [&](int i) -> const Vector3d& { return surface.vertices[static_cast<std::size_t>(i)]; };
    six += at(a).dot(at(b).cross(at(c)));
  }
  return six / 6;
}

/// Whether every edge has one triangle on each side.
bool closed(const TriangleSoup& surface) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& triangle : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
  return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end();
  });
}

AlignedBox3d box_of(const TriangleSoup& surface) {
  AlignedBox3d box;
  for (const auto& triangle : surface.triangles)
    for (const int v : triangle) box.extend(surface.vertices[static_cast<std::size_t>(v)]);
  return box;
}

Points reach_of_arm() {
  Points path(7, 2);
  path.col(0) << -1.2, 0.4, 0, -1.8, 0, 2.2, 0.7;
  path.col(1) << 0.1, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5;
  return path;
}

}  // namespace

TEST_CASE("solids: capsules and balls are closed and have their volume") {
  for (const double length : {0.0, 0.7}) {
    const TriangleSoup capsule =
        capsule_surface({1, 2, 3}, Vector3d(1, 2, 3) + length * Vector3d(0, 0.6, 0.8), 0.2, 64);
    const double exact = kPi * 0.04 * (length + 4.0 / 3 * 0.2);
    CHECK(closed(capsule));
    CHECK(volume(capsule) == Approx(exact).epsilon(0.01));
  }
}

TEST_CASE("solids: hulls are closed and as large as what they are the hull of") {
  std::vector<Vector3d> cube, cylinder, flat;
  for (unsigned k = 0; k < 8; ++k)
    cube.emplace_back((k & 1U) != 0 ? 2 : 0, (k & 2U) != 0 ? 3 : 0, (k & 4U) != 0 ? 0.5 : 0);
  cube.emplace_back(1, 1, 0.2);   // within
  cube.emplace_back(1, 0, 0.25);  // on a side
  const TriangleSoup box = hull_surface(cube);
  CHECK(closed(box));
  CHECK(volume(box) == Approx(3));
  constexpr int kCorners = 48;
  for (int k = 0; k < kCorners; ++k) {
    const double at = 2 * kPi * k / kCorners;
    cylinder.emplace_back(std::cos(at), std::sin(at), -1);
    cylinder.emplace_back(std::cos(at), std::sin(at), 1);
    flat.emplace_back(std::cos(at), std::sin(at), 0);
  }
  const TriangleSoup round = hull_surface(cylinder);
  CHECK(closed(round));
  CHECK(volume(round) == Approx(kCorners * std::sin(2 * kPi / kCorners)));
  CHECK_FALSE(hull_surface(flat).triangles.empty());
  CHECK(std::abs(volume(hull_surface(flat))) < 1e-5);
  CHECK(hull_surface({Vector3d::Zero(), Vector3d::UnitX(), 2 * Vector3d::UnitX()}).triangles.empty());
}

TEST_CASE("solids: a plane in a box looks the way of its normal") {
  const AlignedBox3d box(Vector3d(0, 0, 0), Vector3d(1, 1, 1));
  for (const Vector3d& normal : {Vector3d(0, 0, 2), Vector3d(0, 0, -2), Vector3d(1, 1, 1)}) {
    const TriangleSoup part = plane_in_box(normal, normal.dot(box.center()), box);
    REQUIRE_FALSE(part.triangles.empty());
    for (const auto& [a, b, c] : part.triangles) {
      const auto at = [&](int i) -> const Vector3d& { return part.vertices[static_cast<std::size_t>(i)]; };
      CHECK((at(b) - at(a)).cross(at(c) - at(a)).dot(normal) > 0);
    }
  }
  CHECK(plane_in_box({0, 0, 1}, 5, box).triangles.empty());
}

TEST_CASE("workspace: obstacles of every kind are drawn as they are and what is far off is not") {
  PolygonSoup corner_of_box;
  corner_of_box.positions = {{0.5, 0, 0}, {0.6, 0, 0}, {0.5, 0.1, 0}, {0.5, 0, 0.1}};
  corner_of_box.corners = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  corner_of_box.polygon_begin = {0, 3, 6, 9, 12};
  const TriangleMesh mesh(corner_of_box);
  const std::vector<std::shared_ptr<const Obstacle>> obstacles = {
      make_ball({Vector3d(0.7, 0, 0.5), 0.2}),
      make_box_obstacle({Vector3d(0.5, -0.6, 0), Vector3d(0.7, -0.5, 0.3)}),
      make_cylinder({.radius = 0.1, .height = 0.4, .pose = {.position = Vector3d(0, 0.8, 0.2)}}),
      make_mesh_obstacle(mesh, MeshInside::closed, 0),
      make_half_space({.normal = Vector3d(0, 0, 1), .offset = -0.1}),
      make_ball({Vector3d(50, 0, 0), 0.2})};
  const auto robot = make_dh_arm({});
  const Workspace workspace = robot_workspace(*robot, obstacles, reach_of_arm());
  const double ball = 4 * kPi / 3 * 0.008, box = 0.2 * 0.1 * 0.3, cylinder = kPi * 0.01 * 0.4, corner = 1e-3 / 6;
  CHECK(closed(workspace.obstacles));
  CHECK(volume(workspace.obstacles) == Approx(ball + box + cylinder + corner).epsilon(0.02));
  CHECK(box_of(workspace.obstacles).min()[1] == Approx(-0.6));
  REQUIRE(workspace.notes.size() == 1);
  CHECK(workspace.notes[0] == "obstacles that are far off are not drawn: 1");
  REQUIRE_FALSE(workspace.ground.triangles.empty());
  CHECK(box_of(workspace.ground).max()[2] == Approx(-0.1));
  CHECK(workspace.lower[2] < -0.1 + 1e-9);
  CHECK(workspace.unit == "m");
}

TEST_CASE("workspace: poses begin and end with the path and have the links where the robot has them") {
  const auto robot = make_dh_arm({});
  const Points path = reach_of_arm();
  const Workspace workspace = robot_workspace(*robot, {}, path);
  REQUIRE(workspace.poses.size() % 2 == 1);
  REQUIRE(workspace.capsules.size() == robot->capsules.size());
  std::vector<Frame> links;
  for (const bool end : {false, true}) {
    robot->kinematics->place(path.col(end ? 1 : 0), links);
    const std::vector<DrawnFrame>& pose = end ? workspace.poses.back() : workspace.poses.front();
    for (std::size_t i = 0; i < robot->capsules.size(); ++i) {
      const Capsule& capsule = robot->capsules[i];
      const DrawnCapsule& drawn = workspace.capsules[i];
      const Vector3d place = pose[drawn.link].turn * drawn.to + pose[drawn.link].origin;
      CHECK((place - links[static_cast<std::size_t>(capsule.link)].at(capsule.to)).norm() < 1e-12);
    }
  }
}

}  // namespace leastcost::test
