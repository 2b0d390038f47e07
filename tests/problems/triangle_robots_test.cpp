// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/robot_walls.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include "problems/obstacles/face_obstacle.hpp"
#include "problems/obstacles/segment_tree.hpp"
#include "problems/obstacles/triangle_foot.hpp"
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using Triangle = std::array<Vector3d, 3>;

Triangle random_triangle(std::mt19937& engine, double spread, double size) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&]() -> Vector3d { return Vector3d(number(engine), number(engine), number(engine)); };
  const Vector3d middle = spread * point();
  return {middle + size * point(), middle + size * point(), middle + size * point()};
}

/// A square plate from (-1, -1, 0) to (1, 1, 0) in the frame of the body.
std::shared_ptr<const Robot> square_plate(double radius, double turn = 1) {
  Robot robot;
  robot.kinematics = std::make_shared<const SpatialBody>(turn);
  const Vector3d a(-1, -1, 0), b(1, -1, 0), c(1, 1, 0), d(-1, 1, 0);
  robot.plates = {{0, {a, b, c}, radius}, {0, {a, c, d}, radius}};
  return make_robot(std::move(robot));
}

Eigen::VectorXd pose(double x, double y, double z, double angle, double length = 1) {
  Eigen::VectorXd out(7);
  out << x, y, z, length * std::cos(angle / 2), length * std::sin(angle / 2), 0, 0;  // about the x axis
  return out;
}

}  // namespace

/// Of the nearest of the places of one triangle on a fine lattice, by the nearest points of the other.
TEST_CASE("triangles: their distance is the least of those of their points") {
  std::mt19937 engine(5);
  constexpr int kSteps = 40;
  for (int k = 0; k < 300; ++k) {
    const Triangle first = random_triangle(engine, 1, 1), second = random_triangle(engine, 1, k % 3 == 0 ? 3 : 0.5);
    Vector3d nearest;
    const double found = SegmentTree({second}).distance(first, nearest);
    double sampled = 10;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j) {
        const Vector3d x = first[0] + (first[1] - first[0]) * i / kSteps + (first[2] - first[0]) * j / kSteps;
        sampled = std::min(sampled, (foot_on_triangle(second, x) - x).norm());
      }
    CAPTURE(k, found, sampled);
    const double spacing = ((first[1] - first[0]).norm() + (first[2] - first[0]).norm()) / kSteps;
    CHECK(found <= sampled + 1e-12);
    CHECK(found >= sampled - spacing);
    CHECK((foot_on_triangle(first, nearest) - nearest).norm() < 1e-12);  // it is on it
    CHECK((foot_on_triangle(second, nearest) - nearest).norm() == Approx(found).margin(1e-12));
  }
}

TEST_CASE("triangles: in contact, crossing, degenerate") {
  const Triangle base = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)};
  const SegmentTree tree({base});
  Vector3d nearest;
  CHECK(tree.distance({Vector3d(0.2, 0.2, -1), Vector3d(0.2, 0.2, 1), Vector3d(2, 2, 0.5)}, nearest) == 0);
  CHECK(tree.distance({Vector3d(0.2, 0.2, 0), Vector3d(0.2, 0.2, 1), Vector3d(2, 2, 0.5)}, nearest) == 0);
  CHECK(tree.distance(base, nearest) == 0);
  const Vector3d over(0.2, 0.3, 0.7);
  CHECK(tree.distance({over, over, over}, nearest) == Approx(0.7));
  CHECK(tree.distance({over, Vector3d(0.1, 0.1, 2), over}, nearest) == Approx(0.7));
  CHECK(SegmentTree({{over, over, over}}).distance(base, nearest) == Approx(0.7));
  CHECK((nearest - Vector3d(0.2, 0.3, 0)).norm() < 1e-12);
}

/// Above a ball that it does not reach beyond, a flat plate is its height off.
TEST_CASE("robots of triangles: a plate above a ball, a box and a face, in closed form, and what is refused") {
  const auto ball = make_ball({Vector3d(0.2, -0.3, 0), 0.5});
  const auto box = make_box_obstacle({Vector3d(-3, -3, -1), Vector3d(3, 3, 0)});
  const auto clearance = [](const std::shared_ptr<const Obstacle>& obstacle, const Eigen::VectorXd& a,
                            const Eigen::VectorXd& b) {
    return RobotWalls(square_plate(0.1), {obstacle}, 0).clearance(a, b);
  };
  const MoveClearance sinks = clearance(ball, pose(0, 0, 2, 0), pose(0, 0, 0.75, 0));
  CHECK(sinks.upper == Approx(0.15));
  CHECK(sinks.lower > 0.07);
  // Turned up about the x axis, its lower edge is sin(angle) below its middle.
  const double angle = std::numbers::pi / 6;
  CHECK(clearance(box, pose(0, 0, 1, angle), pose(0.5, 0.5, 1, angle)).upper == Approx(1 - std::sin(angle) - 0.1));
  CHECK(clearance(box, pose(0, 0, -0.5, 0), pose(0, 0, -0.5, 0)).upper == Approx(-0.1));  // within it
  PolygonSoup soup;
  soup.positions = {Vector3d(-9, -9, 0), Vector3d(9, -9, 0), Vector3d(0, 9, 0), Vector3d(0, 9, 0)};
  soup.corners = {0, 1, 2, 2, 1, 0, 2, 3, 2};
  soup.polygon_begin = {0, 3, 6, 9};
  soup.source = "floor.obj";
  const auto faces = make_face_obstacles(TriangleMesh(soup), 0);
  REQUIRE(faces.size() == 1);  // the same from below, and one without area
  const MoveClearance slides = clearance(faces[0], pose(-1, 0, 0.1, 0), pose(1, 0, 0.1, 0));
  CHECK(std::abs(slides.upper) < 1e-12);  // in contact all the way, and proved
  CHECK(slides.lower > -1e-8);

  const auto square = make_polygon({(Eigen::MatrixXd(3, 2) << 0, 0, 1, 0, 0, 1).finished()});
  CHECK(find_ability<MeetsTriangles>(*square) == nullptr);
  CHECK(find_ability<MeetsTriangles>(*make_ball({Eigen::Vector2d(0, 0), 1})) == nullptr);
  Robot planar;
  planar.kinematics = std::make_shared<const PlanarBody>();
  planar.plates = {{0, {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}, 0.1}};
  CHECK_THROWS_WITH(make_robot(planar), Catch::Contains("need a robot in space"));
}

/// Clear or not as the clearance says, which is measured another way.
TEST_CASE("robots of triangles: moves that are clear are told as by their clearance, in scaled turns as well") {
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> number(-1, 1);
  RobotWalls::Obstacles balls;
  for (int i = 0; i < 30; ++i)
    balls.push_back(make_ball({Vector3d(4 * number(engine), 4 * number(engine), 4 * number(engine)), 0.3}));
  constexpr double kTurn = 2.8;
  const RobotWalls walls(square_plate(0.05), balls, 0), scaled(square_plate(0.05, kTurn), balls, 0);
  int clear = 0;
  for (int k = 0; k < 300; ++k) {
    Eigen::VectorXd a = 4 * pose(number(engine), number(engine), number(engine), 0),
                    b = 4 * pose(number(engine), number(engine), number(engine), 0);
    a.tail<4>() = pose(0, 0, 0, 2 * number(engine)).tail<4>();
    b.tail<4>() = pose(0, 0, 0, 2 * number(engine)).tail<4>();
    const MoveClearance least = walls.clearance(a, b);
    CAPTURE(k, least.lower, least.upper);
    CHECK(walls.clears(a, b) == (least.upper >= 0));
    clear += least.upper >= 0 ? 1 : 0;
    a.tail<4>() *= kTurn;
    b.tail<4>() *= kTurn;
    CHECK(scaled.clears(a, b) == (least.upper >= 0));
    CHECK(scaled.clearance(a, b).upper == Approx(least.upper).epsilon(0.5).margin(1e-9));  // as nearly as was asked
  }
  CHECK(clear > 20);
  CHECK(clear < 280);
}

}  // namespace leastcost
