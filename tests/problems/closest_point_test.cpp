// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/closest_point.hpp>

#include <Eigen/Geometry>
#include <limits>
#include <random>

#include <leastcost/problems/readers/mesh_reader.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/trials.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
using test::add_polygon;

constexpr unsigned kSeed = 20260102;

double distance_to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d side = b - a;
  const double length = side.squaredNorm();
  const double s = length > 0 ? std::clamp((p - a).dot(side) / length, 0.0, 1.0) : 0.0;
  return (p - a - s * side).norm();
}

/// Straight from the definition: the least of three sides and, where the foot of the perpendicular lies inside, the
/// distance to the plane.
double distance_to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  double least = std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
  const Vector3d normal = (b - a).cross(c - a);
  if (!(normal.norm() > 0)) return least;
  const auto left_of = [&](const Vector3d& from, const Vector3d& to) {
    return normal.dot((to - from).cross(p - from)) >= 0;
  };
  if (left_of(a, b) && left_of(b, c) && left_of(c, a))
    least = std::min(least, std::abs(normal.normalized().dot(p - a)));
  return least;
}

double brute_force(const TriangleMesh& mesh, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.faces()) {
    least = std::min(least, distance_to_triangle(p, mesh.position(a), mesh.position(b), mesh.position(c)));
  }
  return least;
}

/// That the answer is a point of the surface, as far away as it says, and at the given distance. `tolerance` is a
/// length.
void check_answer(const TriangleMesh& mesh, const Vector3d& p, const ClosestPoint& answer, double distance,
                  double tolerance) {
  REQUIRE(answer.where.face >= 0);
  REQUIRE(answer.where.face < mesh.face_count());
  CHECK(answer.where.barycentric.minCoeff() >= 0);
  CHECK(std::abs(answer.where.barycentric.sum() - 1) < 1e-15 * 8);
  CHECK((mesh.point(answer.where) - answer.position).norm() <= tolerance);
  CHECK(std::abs((p - answer.position).norm() - answer.distance) <= tolerance);
  CHECK(std::abs(answer.distance - distance) <= tolerance);
}

Vector3d random_vector(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  const double x = normal(engine), y = normal(engine), z = normal(engine);
  return {x, y, z};
}

/// Points on, near, around and far from the surface, each asked without a hint, with the right one and with a wrong
/// one.
void check_mesh(const TriangleMesh& mesh, int points) {
  std::mt19937_64 engine(kSeed);
  const ClosestPointTree tree(mesh);
  const double size = mesh.diameter();
  const auto random_face = [&] {
    return static_cast<std::int32_t>(engine() % static_cast<std::uint64_t>(mesh.face_count()));
  };
  for (int i = 0; i < points; ++i) {
    for (const double away : {0.0, 1e-9, 1e-3, 0.3, 100.0}) {
      const Vector3d p = mesh.point({random_face(), {0.2, 0.3, 0.5}}) + away * size * random_vector(engine);
      const double expected = brute_force(mesh, p);
      const double tolerance = 1e-14 * (size + expected);
      const ClosestPoint plain = tree.nearest(p);
      check_answer(mesh, p, plain, expected, tolerance);
      for (const std::int32_t hint : {plain.where.face, random_face(), mesh.face_count() + 7}) {
        check_answer(mesh, p, tree.nearest(p, hint), expected, tolerance);
      }
    }
  }
}

}  // namespace

TEST_CASE("closest point: agrees with a brute-force search", "[closest_point]") {
  check_mesh(TriangleMesh(test::cube()), 20);
  check_mesh(TriangleMesh(test::sphere(3)), 20);
  check_mesh(TriangleMesh(test::grid(20, 3, test::Closing::kTwisted, false)), 20);
  check_mesh(TriangleMesh(test::octahedron(), {false, 4}), 20);
}

TEST_CASE("closest point: one triangle, every region around it", "[closest_point]") {
  std::mt19937_64 engine(kSeed);
  for (int round = 0; round < 300; ++round) {
    PolygonSoup soup;
    // From round to nearly degenerate, in all orders of corners.
    const double thinness = std::pow(10.0, -(round % 13));
    const Vector3d a = random_vector(engine), along = random_vector(engine);
    const double place = round % 2 == 0 ? 0.4 : 1e-3;
    soup.positions = {a, a + along, a + place * along + thinness * random_vector(engine)};
    std::shuffle(soup.positions.begin(), soup.positions.end(), engine);
    add_polygon(soup, {0, 1, 2});
    const TriangleMesh mesh(soup);
    const ClosestPointTree tree(mesh);
    for (int i = 0; i < 100; ++i) {
      const Vector3d p = a + 0.5 * along + random_vector(engine);
      const double expected = distance_to_triangle(p, soup.positions[0], soup.positions[1], soup.positions[2]);
      const ClosestPoint answer = tree.nearest(p, i % 2 - 1);
      // The plane of a thin triangle is known to rounding / thinness; that far off the inside test may be, and the
      // distance by no more than that.
      check_answer(mesh, p, answer, expected, 1e-14 * (1 + 1e-2 / std::max(thinness, 1e-8)));
    }
  }
}

TEST_CASE("closest point: triangles without area are segments and points", "[closest_point]") {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {0, 9, 0}, {0, 9, 0}, {1, 9, 0}};
  add_polygon(soup, {0, 1, 2});
  add_polygon(soup, {3, 4, 5});
  add_polygon(soup, {6, 7, 8});
  const TriangleMesh mesh(soup);
  REQUIRE(mesh.face_count() == 3);
  const ClosestPointTree tree(mesh);
  for (const std::int32_t hint : {-1, 0, 1, 2}) {
    CHECK(tree.nearest({2, 1, 0}, hint).position == Vector3d(2, 0, 0));
    CHECK(tree.nearest({-3, 4, 0}, hint).distance == 5);
    CHECK(tree.nearest({5, 5, 7}, hint).distance == 2);
    CHECK(tree.nearest({0.25, 10, 0}, hint).position == Vector3d(0.25, 9, 0));
  }
  check_mesh(mesh, 30);
}

TEST_CASE("closest point: many faces at one place neither loop nor overflow", "[closest_point]") {
  PolygonSoup soup;
  for (int i = 0; i < 3000; ++i) {
    for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}) soup.positions.push_back(p);
    add_polygon(soup, {3 * i, 3 * i + 1, 3 * i + 2});
  }
  // Sizes that double: every split separates only a few.
  for (int i = 0; i < 200; ++i) {
    const double size = std::ldexp(1.0, i - 100);
    const std::int32_t first = static_cast<std::int32_t>(soup.positions.size());
    for (const Vector3d& p : {Vector3d(size, 0, 0), Vector3d(2 * size, 0, 0), Vector3d(size, size, 0)})
      soup.positions.push_back(p);
    add_polygon(soup, {first, first + 1, first + 2});
  }
  const TriangleMesh mesh(soup);
  const ClosestPointTree tree(mesh);
  CHECK(tree.nearest({0.25, 0.25, 3}).distance == 3);
  CHECK(tree.nearest({0.25, 0.25, 3}).where.face == 0);
  CHECK(tree.nearest({0.25, 0.25, 3}, 2999).where.face == 2999);
}

TEST_CASE("closest point: ties go to the hint, else to the lowest face", "[closest_point]") {
  const TriangleMesh mesh(test::cube());
  const ClosestPointTree tree(mesh);
  CHECK(tree.nearest({0, 0, 0}).where.face == 0);
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) CHECK(tree.nearest({0, 0, 0}, f).where.face == f);
  // Outside an edge or a corner, all faces around it are equally near, to the last bit.
  std::mt19937_64 engine(kSeed);
  const TriangleMesh ball(test::sphere(3));
  const ClosestPointTree ball_tree(ball);
  for (std::int32_t h = 0; h < 3 * ball.face_count(); ++h) {
    const std::int32_t f = h / 3, other = ball.across(h) / 3;
    const double t = std::uniform_real_distribution<double>(0.1, 0.9)(engine);
    const Vector3d on_edge = (1 - t) * ball.position(ball.tail(h)) + t * ball.position(ball.head(h));
    const Vector3d p = on_edge + 0.3 * (ball.face_normal(f) + ball.face_normal(other)).normalized();
    const ClosestPoint plain = ball_tree.nearest(p), one = ball_tree.nearest(p, f), two = ball_tree.nearest(p, other);
    CHECK(plain.where.face == std::min(f, other));
    CHECK(one.where.face == f);
    CHECK(two.where.face == other);
    CHECK(one.position == two.position);
    CHECK(one.position == plain.position);
  }
  for (std::int32_t v = 0; v < ball.vertex_count(); ++v) {
    for (const std::int32_t f : ball.faces_of_vertex(v)) {
      const ClosestPoint answer = ball_tree.nearest(1.5 * ball.position(v), f);
      CHECK(answer.where.face == f);
      CHECK(answer.position == ball.position(v));
    }
  }
}

TEST_CASE("closest point: subdivision changes no distance", "[closest_point]") {
  std::mt19937_64 engine(kSeed);
  const PolygonSoup soup = test::sphere(2);
  const TriangleMesh coarse(soup), fine(soup, {false, 3});
  const ClosestPointTree coarse_tree(coarse), fine_tree(fine);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = random_vector(engine);
    const ClosestPoint a = coarse_tree.nearest(p), b = fine_tree.nearest(p);
    CHECK(std::abs(a.distance - b.distance) < 1e-14);
    CHECK((a.position - b.position).norm() < 1e-12);
    CHECK((coarse.point(coarse.locate(fine.in_file(b.where))) - a.position).norm() < 1e-12);
  }
}

TEST_CASE("closest point: a point that moves along finds the same as one that does not remember", "[closest_point]") {
  std::mt19937_64 engine(kSeed);
  // A flat strip folded so that sheets lie close to each other: the hint is often on the wrong one.
  PolygonSoup soup = test::grid(200, 4, test::Closing::kOpen, false);
  for (Vector3d& p : soup.positions) {
    const double along = std::atan2(p.y(), p.x());
    p = Vector3d(std::sin(20 * along), along * 0.01, p.head<2>().norm() - 3);
  }
  const TriangleMesh mesh(soup);
  const ClosestPointTree tree(mesh);
  Vector3d p = mesh.position(0);
  std::int32_t hint = 0;
  for (int i = 0; i < 3000; ++i) {
    p += 0.01 * random_vector(engine);
    const ClosestPoint with = tree.nearest(p, hint), without = tree.nearest(p);
    CHECK(std::abs(with.distance - without.distance) < 1e-15);
    hint = with.where.face;
    p = 0.5 * (p + with.position);
  }
}

TEST_CASE("closest point: a point that is not finite or absurdly far has no answer", "[closest_point]") {
  const TriangleMesh mesh(test::cube());
  const ClosestPointTree tree(mesh);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const Vector3d& p : {Vector3d(nan, 0, 0), Vector3d(0, infinity, 0), Vector3d(0, 0, -1e200)}) {
    for (const std::int32_t hint : {-1, 0, 5}) {
      const ClosestPoint answer = tree.nearest(p, hint);
      CHECK(answer.where.face == -1);
      CHECK(std::isnan(answer.distance));
      CHECK(answer.position.hasNaN());
    }
  }
  CHECK(tree.nearest({0, 0, 1e140}).distance == Approx(1e140));
}

TEST_CASE("closest point: tiny and huge units", "[closest_point]") {
  for (const double unit : {1e-60, 1e60}) {
    PolygonSoup soup = test::sphere(2);
    for (Vector3d& p : soup.positions) p *= unit;
    check_mesh(TriangleMesh(soup), 5);
  }
}

TEST_CASE("closest point: agrees with a brute-force search on real meshes, clean and dirty", "[closest_point]") {
  // The largest, the one with needles of 0.0007 degrees, zero-area and duplicate faces, boundaries.
  for (const char* name : {"meshes/bunny_70k.obj", "meshes/anchor_dense.off", "meshes/motor_soup.stl",
                           "meshes/dragon_48k_dirty.ply", "meshes/wuson_dirty.off", "meshes/double-torus.off"}) {
    const auto file = test::data_file(name);
    if (!file) continue;
    INFO(name);
    check_mesh(TriangleMesh(read_mesh(*file)), test::trials(12));
  }
}

}  // namespace leastcost
