// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/robots/covering.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <leastcost/problems/readers/mesh_reader.hpp>
#include "problems/robots/cover_mesh.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/refused_key.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;

/// Of a point from the nearest capsule, negative inside; in extended precision.
double outside(const Covering& cover, const Vector3d& point) {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  long double least = 1e300L;
  for (const Capsule& capsule : cover.capsules) {
    const Wide from = capsule.from.cast<long double>(), way = capsule.to.cast<long double>() - from,
               off = point.cast<long double>() - from;
    const long double square = way.squaredNorm();
    const long double t = square > 0 ? std::clamp(off.dot(way) / square, 0.0L, 1.0L) : 0.0L;
    least = std::min(least, (off - t * way).norm() - static_cast<long double>(capsule.radius));
  }
  return static_cast<double>(least);
}

double volume(const Capsule& capsule) {
  return kPi * capsule.radius * capsule.radius * ((capsule.to - capsule.from).norm() + 4.0 / 3 * capsule.radius);
}

/// How far a capsule reaches in a direction.
double support(const Covering& cover, const Vector3d& way) {
  double most = -1e300;
  for (const Capsule& c : cover.capsules) most = std::max(most, std::max(way.dot(c.from), way.dot(c.to)) + c.radius);
  return most;
}

Vector3d random_way(std::mt19937& engine) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(engine), normal(engine), normal(engine)).normalized();
}

}  // namespace

TEST_CASE("covering: a box is covered inside as well and by no more than is said") {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  for (const Vector3d& size : {Vector3d(0.1, 0.06, 0.4), Vector3d(1, 1, 1), Vector3d(0.02, 0.5, 0.3),
                               Vector3d(0.3, 2, 0.3), Vector3d(3, 2, 0.01)}) {
    const Covering cover = cover_box(size);
    CHECK(cover.capsules.size() <= 8);
    for (int k = 0; k < 20000; ++k) {
      Vector3d p(unit(engine), unit(engine), unit(engine));
      if (k < 8) p = Vector3d(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);  // its corners
      CHECK(outside(cover, p.cwiseProduct(size)) <= 0);
    }
    double farthest = 0;
    for (int k = 0; k < 20000; ++k) {
      const Vector3d way = random_way(engine);
      farthest = std::max(farthest, support(cover, way) - way.cwiseAbs().dot(size) / 2);
    }
    for (int axis = 0; axis < 3; ++axis)
      farthest = std::max(farthest, support(cover, Vector3d::Unit(axis)) - size[axis] / 2);
    CHECK(farthest == Approx(cover.adds).epsilon(1e-9));
    Vector3d edges = size;
    std::sort(edges.data(), edges.data() + 3);
    const double strip = edges[1] / static_cast<double>(cover.capsules.size());
    CHECK(cover.adds < std::hypot(strip, edges[0]) / 2);  // what a capsule from face to face would add
  }
  CHECK(refused_key([] { cover_box(Vector3d(1, 0, 1)); }) == "size");
  CHECK(refused_key([] { cover_box(Vector3d(1, std::nan(""), 1)); }) == "size");
}

TEST_CASE("covering: a cylinder is covered from face to face") {
  for (const auto& [length, radius] : {std::pair{0.4, 0.05}, std::pair{0.02, 0.1}, std::pair{1.0, 1.0}}) {
    const Covering cover = cover_cylinder(length, radius);
    for (int k = 0; k < 360; ++k)
      for (const double z : {-length / 2, length / 2})
        CHECK(outside(cover, {radius * std::cos(k), radius * std::sin(k), z}) <= 0);
    CHECK(support(cover, Vector3d::UnitZ()) - length / 2 <= cover.adds * (1 + 1e-12));
    CHECK(support(cover, Vector3d::UnitX()) - radius <= cover.adds * (1 + 1e-12));
  }
  CHECK(cover_cylinder(0.4, 0.05).adds < 0.046);  // less than half a ball of its radius
  CHECK(refused_key([] { cover_cylinder(0, 1); }) == "length");
  CHECK(refused_key([] { cover_cylinder(1, -1); }) == "radius");
}

TEST_CASE("covering: points get a capsule that holds all of them and is hardly larger than it must be") {
  std::mt19937 engine(8);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int trial = 0; trial < 6; ++trial) {
    const Vector3d a = random_way(engine) * 0.3, b = a + random_way(engine) * (0.1 + 0.2 * trial);
    const double radius = 0.1;
    std::vector<Vector3d> points;  // of the surface of a capsule
    while (points.size() < 3000) {
      const Vector3d p = a + unit(engine) * (b - a) + radius * random_way(engine);
      const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      points.push_back(a + t * (b - a) + radius * (p - a - t * (b - a)).normalized());
    }
    const Covering cover = cover_points(points);
    REQUIRE(cover.capsules.size() == 1);
    for (const Vector3d& p : points) CHECK(outside(cover, p) <= 0);
    CHECK(volume(cover.capsules[0]) < 1.03 * volume({0, a, b, radius}));
    CHECK(cover.adds < 0.02 * (radius + (b - a).norm()));
  }
  CHECK(cover_points({Vector3d(1, 2, 3)}).capsules[0].radius < 1e-13);
  CHECK(cover_points({Vector3d(1, 2, 3)}).capsules[0].radius > 0);
  const Covering flat = cover_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(1, 1, 0), Vector3d(0.5, 0.5, 0)}) CHECK(outside(flat, p) <= 0);
  CHECK(refused_key([] { cover_points({}); }) == "points");
  CHECK(refused_key([] { cover_points({Vector3d(0, std::nan(""), 0)}); }) == "points");
}

TEST_CASE("covering: the meshes of arms get capsules about as large as those of the built-in ones") {
  for (const auto& [name, most] : {std::pair{"panda_meshes/link2.obj", 6e-3},
                                   {"panda_meshes/hand.obj", 2.5e-3},
                                   {"ur5_meshes/forearm.stl", 9e-3}}) {
    const auto file = data_file(std::string("planning/mbm/") + name);
    if (!file) return;
    const std::vector<Vector3d> points = read_mesh(*file).positions;
    const Covering cover = cover_points(points);
    for (const Vector3d& p : points) CHECK(outside(cover, p) <= 0);
    CHECK(volume(cover.capsules[0]) < most);
    CHECK(cover.adds < 0.06);
  }
}

TEST_CASE("covering: a bent solid is covered by several capsules - also inside") {
  // An L of two arms, 0.3 long and 0.05 thick, somewhere in space.
  const std::vector<Eigen::Vector2d> outline = {{0, 0}, {0.3, 0}, {0.3, 0.05}, {0.05, 0.05}, {0.05, 0.3}, {0, 0.3}};
  const Eigen::Isometry3d pose =
      Eigen::Translation3d(0.4, -1, 2) * Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized());
  std::vector<Vector3d> points;
  for (const double y : {0.0, 0.05})
    for (const Eigen::Vector2d& at : outline) points.push_back(pose * Vector3d(at[0], y, at[1]));
  std::vector<std::array<std::int32_t, 3>> faces;
  for (std::int32_t k = 0; k < 6; ++k) {
    const std::int32_t next = (k + 1) % 6;
    faces.push_back({k, next, next + 6});
    faces.push_back({k, next + 6, k + 6});
  }
  for (std::int32_t k = 1; k < 5; ++k)
    for (const std::int32_t side : {0, 6}) faces.push_back({side, side + k, side + k + 1});
  const Covering cover = cover_mesh(points, faces), one = cover_points(points);
  CHECK(cover.capsules.size() >= 2);
  CHECK(cover.capsules.size() <= 8);
  double all = 0;
  for (const Capsule& capsule : cover.capsules) all += volume(capsule);
  CHECK(all < 0.6 * volume(one.capsules[0]));
  CHECK(cover.adds < one.adds);
  for (const Vector3d& point : points) CHECK(outside(cover, point) <= 0);
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 4000; ++k) {
    Vector3d place(0.3 * unit(engine), 0.05 * unit(engine), 0.05 * unit(engine));
    if (k % 2 == 0) std::swap(place[0], place[2]);
    CHECK(outside(cover, pose * place) <= 0);
  }
  // As far beyond the hull as is said, nearly.
  double beyond = 0;
  for (int k = 0; k < 4000; ++k) {
    const Vector3d way = random_way(engine);
    double farthest = -1e300;
    for (const Vector3d& point : points) farthest = std::max(farthest, way.dot(point));
    beyond = std::max(beyond, support(cover, way) - farthest);
  }
  CHECK(beyond == Approx(cover.adds).epsilon(0.1));
  CHECK(cover_mesh(points, {}).capsules.size() >= 1);
  CHECK(refused_key([&] { cover_mesh(points, {{0, 1, 12}}); }) == "faces");
  CHECK(refused_key([&] { cover_mesh({}, {}); }) == "points");
  CHECK(cover_mesh({Vector3d(1, 2, 3)}, {{0, 0, 0}}).capsules.size() == 1);
}

}  // namespace leastcost::test
