// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/straighten/straighten.hpp>

#include <cmath>
#include <numbers>
#include <set>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include "problems/mesh/trace.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

constexpr double kStraight = -1e-9;  // radians, what a certificate asks for

SurfacePath edge_path(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  EdgeGraphSearch graph(mesh);
  return graph.shortest(a, b, [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return (q - p).norm(); }).path;
}

SurfacePath edge_path(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  return edge_path(mesh, vertex_point(mesh, a), vertex_point(mesh, b));
}

/// Everything that must hold for any straightened path.
void check_result(const TriangleMesh& mesh, const SurfacePath& start, const Straightened& s,
                  const MetricRoot& metric = {}) {
  REQUIRE(s.finished);
  REQUIRE(s.path.points.front() == start.points.front());
  REQUIRE(s.path.points.back() == start.points.back());
  REQUIRE(lies_on(mesh, s.path));
  REQUIRE(s.final_length <= s.initial_length * (1 + 1e-14));
  REQUIRE(s.initial_length == Approx(path_length(start, metric)).epsilon(1e-14));
  REQUIRE(s.final_length == Approx(path_length(s.path, metric)).epsilon(1e-14));
  REQUIRE(check_straight(mesh, s.path, metric) >= kStraight);
}

double straight_length(const TriangleMesh& mesh, std::int32_t a, std::int32_t b) {
  const SurfacePath start = edge_path(mesh, a, b);
  const Straightened s = straighten(mesh, start);
  check_result(mesh, start, s);
  return s.final_length;
}

/// A box with one corner at the origin, each side cut into k x k quads.
TriangleMesh box(double x, double y, double z, int subdivide) {
  PolygonSoup soup = test::cube();
  for (Eigen::Vector3d& p : soup.positions)
    p = (p + Eigen::Vector3d::Constant(0.5)).cwiseProduct(Eigen::Vector3d(x, y, z));
  return TriangleMesh(soup, {false, subdivide});
}

/// The unit square as n x n quads, with the quads that `keep` refuses left out; vertices shaken inside the plane.
template <class Keep>
TriangleMesh square(int n, double shake, test::Random& random, Keep keep) {
  PolygonSoup soup;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const bool rim = i % (n / 4) == 0 || j % (n / 4) == 0;  // lines that hole corners lie on stay
      const double s = rim ? 0 : shake / n;
      soup.positions.emplace_back(double(i) / n + random.uniform(-s, s), double(j) / n + random.uniform(-s, s), 0.0);
    }
  }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      if (keep((i + 0.5) / n, (j + 0.5) / n))
        test::add_polygon(soup,
                          {j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i});
  return TriangleMesh(soup);
}

std::int32_t nearest_vertex(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  std::int32_t best = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
    if ((mesh.position(v) - p).norm() < (mesh.position(best) - p).norm()) best = v;
  return best;
}

SurfacePoint random_point(const TriangleMesh& mesh, test::Random& random) {
  Eigen::Vector3d b(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
  const int kind = random.integer(0, 3);
  if (kind == 0) b[random.integer(0, 2)] = 0;
  if (kind == 1) b = Eigen::Vector3d::Unit(random.integer(0, 2));
  return {random.integer(0, mesh.face_count() - 1), b / b.sum()};
}

}  // namespace

TEST_CASE("corner to corner of boxes") {
  for (int subdivide = 0; subdivide <= 4; ++subdivide) {
    CAPTURE(subdivide);
    CHECK(straight_length(box(1, 1, 1, subdivide), 0, 7) == Approx(std::sqrt(5.0)).epsilon(1e-14));
    const TriangleMesh brick = box(1, 2, 3, subdivide);
    GeodesicSearch search(brick);
    const Geodesic shortest = search.shortest(vertex_point(brick, 0), vertex_point(brick, 7));
    REQUIRE(shortest.found());
    CHECK(shortest.result.final_length == Approx(std::sqrt(18.0)).epsilon(1e-14));
  }
}

TEST_CASE("on a flat mesh the result is the straight line") {
  test::Random random;
  const TriangleMesh mesh = square(16, 0.3, random, [](double, double) { return true; });
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint a = random_point(mesh, random), b = random_point(mesh, random);
    const SurfacePath start = edge_path(mesh, a, b);
    if (start.faces.empty()) continue;
    const Straightened s = straighten(mesh, start);
    check_result(mesh, start, s);
    CHECK(s.final_length == Approx((mesh.point(a) - mesh.point(b)).norm()).epsilon(1e-13));
  }
}

TEST_CASE("around a hole the path bends at its corner, exactly") {
  test::Random random;
  // An L: the upper right quarter is missing.
  const TriangleMesh mesh = square(16, 0.3, random, [](double x, double y) { return x < 0.5 || y < 0.5; });
  const Eigen::Vector3d a(0.25, 1, 0), corner(0.5, 0.5, 0), b(1, 0.25, 0);
  const double exact = (a - corner).norm() + (corner - b).norm();
  CHECK(straight_length(mesh, nearest_vertex(mesh, a), nearest_vertex(mesh, b)) == Approx(exact).epsilon(1e-14));

  // A square hole in the middle, passed on the side of the first path.
  const TriangleMesh holed =
      square(16, 0.3, random, [](double x, double y) { return std::max(std::abs(x - 0.5), std::abs(y - 0.5)) > 0.25; });
  const Eigen::Vector3d c(0, 0.25, 0), d(1, 0.75, 0), low(0.75, 0.25, 0);
  const double around = (c - low).norm() + (low - d).norm();
  CHECK(straight_length(holed, nearest_vertex(holed, c), nearest_vertex(holed, d)) == Approx(around).epsilon(1e-14));
}

TEST_CASE("flat distances of the tvb-gdist test mesh") {
  const auto file = test::data_file("truth/flat_triangular_mesh.off");
  if (!file) return;
  const TriangleMesh mesh(read_mesh(*file));
  for (std::int32_t v = 1; v < mesh.vertex_count(); v += 3) {
    const double exact = (mesh.position(v) - mesh.position(0)).norm();
    CHECK(straight_length(mesh, 0, v) == Approx(exact).epsilon(1e-13));
  }
}

TEST_CASE("paths bend around saddle vertices and never over convex ones") {
  // Six faces around the origin, the rim up and down in turn: cone angle above 2 pi.
  PolygonSoup saddle;
  saddle.positions.emplace_back(0, 0, 0);
  for (int i = 0; i < 6; ++i) {
    const double t = std::numbers::pi * i / 3;
    saddle.positions.emplace_back(std::cos(t), std::sin(t), i % 2 == 0 ? 0.8 : -0.8);
  }
  for (int i = 0; i < 6; ++i) test::add_polygon(saddle, {0, 1 + i, 1 + (i + 1) % 6});
  const TriangleMesh mesh(saddle);
  REQUIRE(mesh.vertex_angle(0) > 2 * std::numbers::pi);
  const SurfacePath over =
      path_from_vertices(mesh, vertex_point(mesh, 1), std::vector<std::int32_t>{0}, vertex_point(mesh, 4));
  const Straightened s = straighten(mesh, over);
  check_result(mesh, over, s);
  CHECK(s.final_length == s.initial_length);  // half of the cone angle on each side: straight already

  const TriangleMesh cube(test::cube(), {false, 2});  // over a corner of the cube: three right angles
  const SurfacePath corner =
      path_from_vertices(cube, vertex_point(cube, 1), std::vector<std::int32_t>{}, vertex_point(cube, 1));
  CHECK(corner.faces.empty());
  const SurfacePath start = edge_path(cube, 1, 2);
  const Straightened t = straighten(cube, start);
  check_result(cube, start, t);
  CHECK(t.final_length == Approx(std::sqrt(2.0)).epsilon(1e-14));
}

TEST_CASE("a constant metric is the Euclidean problem of the transformed mesh") {
  test::Random random;
  Eigen::Matrix3d root;
  root << 1.0, 0.3, 0.0, 0.0, 2.0, 0.1, 0.0, 0.0, 0.5;
  PolygonSoup soup = test::sphere(3);
  const TriangleMesh mesh(soup);
  for (Eigen::Vector3d& p : soup.positions) p = root * p;
  const TriangleMesh transformed(soup);
  StraightenOptions options;
  options.metric = root;
  for (int i = 0; i < 20; ++i) {
    const SurfacePoint a = random_point(mesh, random), b = random_point(mesh, random);
    const SurfacePath start = edge_path(mesh, a, b);
    if (start.faces.empty()) continue;
    SurfacePath image = start;
    for (Eigen::Vector3d& p : image.points) p = root * p;
    const Straightened s = straighten(mesh, start, options), t = straighten(transformed, image);
    check_result(mesh, start, s, root);
    CHECK(s.final_length == Approx(t.final_length).epsilon(1e-12));
  }
}

TEST_CASE("one-sided and flipped meshes straighten like any other") {
  test::Random random;
  const TriangleMesh band(test::grid(40, 8, test::Closing::kTwisted, false));
  const TriangleMesh bottle(test::grid(24, 16, test::Closing::kTwisted, true));
  for (const TriangleMesh* mesh : {&band, &bottle}) {
    for (int i = 0; i < 40; ++i) {
      const SurfacePath start = edge_path(*mesh, random_point(*mesh, random), random_point(*mesh, random));
      if (start.faces.empty()) continue;
      const Straightened forward = straighten(*mesh, start);
      check_result(*mesh, start, forward);
      const Straightened backward = straighten(*mesh, reversed(forward.path));
      CHECK(backward.final_length == Approx(forward.final_length).epsilon(1e-13));
    }
  }
}

TEST_CASE("a vertex where two sheets meet is a fixed point of the path") {
  const auto file = test::data_file("meshes/hourglass.obj");
  if (!file) return;
  const TriangleMesh mesh(read_mesh(*file));
  std::int32_t waist = -1, low = 0, high = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.neighbours(v).size() >= 10) waist = v;
    if (mesh.position(v).y() < mesh.position(low).y()) low = v;
    if (mesh.position(v).y() > mesh.position(high).y()) high = v;
  }
  REQUIRE(waist >= 0);
  const SurfacePath start = edge_path(mesh, low, high);
  const Straightened s = straighten(mesh, start);
  check_result(mesh, start, s);
  bool through_waist = false;
  for (const Eigen::Vector3d& p : s.path.points) through_waist = through_waist || p == mesh.position(waist);
  CHECK(through_waist);
  CHECK(s.final_length ==
        Approx(straight_length(mesh, low, waist) + straight_length(mesh, waist, high)).epsilon(1e-12));
}

TEST_CASE("an edge with three faces in the way is named") {
  const auto file = test::data_file("meshes/fan3.obj");
  if (!file) return;
  const TriangleMesh mesh(read_mesh(*file));
  REQUIRE(mesh.non_manifold_edges().size() == 1);
  const SurfacePath over =
      path_from_vertices(mesh, vertex_point(mesh, mesh.vertex_of_file(0)),
                         std::vector<std::int32_t>{mesh.vertex_of_file(2)}, vertex_point(mesh, mesh.vertex_of_file(1)));
  REQUIRE_THROWS_WITH(straighten(mesh, over), Catch::Contains("vertex 4") && Catch::Contains("vertex 2"));
  CHECK(check_straight(mesh, over) < kStraight);
  // Along that edge itself nothing needs to be unfolded.
  const SurfacePath along = path_from_vertices(mesh, vertex_point(mesh, mesh.vertex_of_file(2)),
                                               std::vector<std::int32_t>{}, vertex_point(mesh, mesh.vertex_of_file(4)));
  check_result(mesh, along, straighten(mesh, along));
}

TEST_CASE("the checker sees what is not straight") {
  const TriangleMesh mesh(test::sphere(3));
  const SurfacePath edges = edge_path(mesh, 0, 100);
  CHECK(check_straight(mesh, edges) < -0.01);
  SurfacePath bent = straighten(mesh, edges).path;
  REQUIRE(check_straight(mesh, bent) >= kStraight);
  REQUIRE(bent.points.size() > 4);
  // One crossing moved along its edge by a millionth of the diameter.
  const std::size_t k = bent.points.size() / 2;
  const auto& before = mesh.face(bent.faces[k - 1]);
  const auto& after = mesh.face(bent.faces[k]);
  const std::set<std::int32_t> corners(before.begin(), before.end());
  std::vector<std::int32_t> shared;
  for (const std::int32_t v : after)
    if (corners.count(v) == 1) shared.push_back(v);
  REQUIRE(shared.size() == 2);
  bent.points[k] += 1e-6 * (mesh.position(shared[1]) - mesh.position(shared[0]));
  CHECK(check_straight(mesh, bent) < kStraight);
  bent.faces[k] = bent.faces[k] == 0 ? 1 : 0;  // jumps
  CHECK(check_straight(mesh, bent) == -std::numeric_limits<double>::infinity());
  CHECK(check_straight(mesh, SurfacePath{}) == -std::numeric_limits<double>::infinity());
}

TEST_CASE("stopping early gives a valid path that says so") {
  const TriangleMesh mesh(test::sphere(5));
  const SurfacePath start = edge_path(mesh, 0, 3);
  StraightenOptions options;
  options.stop = [] { return true; };
  const Straightened s = straighten(mesh, start, options);
  CHECK(!s.finished);
  CHECK(s.moves == 0);  // not even those of the first sweep
  CHECK(lies_on(mesh, s.path));
  CHECK(s.final_length <= s.initial_length * (1 + 1e-14));
}

TEST_CASE("degenerate faces do no harm") {
  // A flat square whose middle row of faces has no area: two rows of vertices on one line.
  PolygonSoup soup;
  const int n = 8;
  const std::vector<double> rows{0.0, 0.3, 0.3, 1.0};
  for (const double y : rows)
    for (int i = 0; i <= n; ++i) soup.positions.emplace_back(double(i) / n, y, 0.0);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + n + 1;
      test::add_polygon(soup, {a, a + 1, b + 1});
      test::add_polygon(soup, {a, b + 1, b});
    }
  const TriangleMesh mesh(soup);
  const std::int32_t last = mesh.vertex_count() - 1;
  for (const std::int32_t a : {0, 2, n}) {
    for (const std::int32_t b : {last, last - 3, last - n}) {
      const SurfacePath start = edge_path(mesh, a, b);
      const Straightened s = straighten(mesh, start);
      CHECK(s.finished);
      CHECK(lies_on(mesh, s.path));
      CHECK(s.final_length <= s.initial_length * (1 + 1e-14));
      CHECK(s.final_length >= (mesh.position(a) - mesh.position(b)).norm() * (1 - 1e-14));
    }
  }
}

TEST_CASE("fine meshes: long strips are straightened by shots, to the same standard") {
  test::Random random;
  for (const char* name : {"meshes/duck.obj", "meshes/knot1.off", "meshes/lion.off"}) {
    const auto file = test::data_file(name);
    if (!file) continue;
    CAPTURE(name);
    const TriangleMesh mesh(read_mesh(*file), {false, 2});
    for (int i = 0; i < 10; ++i) {
      const SurfacePath start = edge_path(mesh, random_point(mesh, random), random_point(mesh, random));
      if (start.faces.empty()) continue;
      const Straightened s = straighten(mesh, start);
      check_result(mesh, start, s);
      StraightenOptions step_by_step;
      step_by_step.shortcuts = false;
      const Straightened t = straighten(mesh, start, step_by_step);
      check_result(mesh, start, t);
    }
  }
}

TEST_CASE("random paths on real meshes") {
  test::Random random;
  for (const char* name :
       {"meshes/duck.obj", "meshes/spot.obj", "meshes/lion.off", "meshes/knot1.off", "meshes/moebius.obj",
        "meshes/double-torus_tri.off", "meshes/cow.off", "meshes/anchor_dense.off", "meshes/camelhead.off",
        "meshes/polygon_mesh.off", "meshes/teapot_dirty.obj", "meshes/blobby_shuffled.off"}) {
    const auto file = test::data_file(name);
    if (!file) continue;
    CAPTURE(name);
    const TriangleMesh mesh(read_mesh(*file));
    for (int i = 0; i < 15; ++i) {
      const SurfacePoint a = random_point(mesh, random), b = random_point(mesh, random);
      const SurfacePath start = edge_path(mesh, a, b);
      if (start.faces.empty()) continue;
      StraightenOptions options;
      options.flips = i % 3 == 0;
      options.shortcuts = i % 2 == 0;
      const Straightened s = straighten(mesh, start, options);
      check_result(mesh, start, s);
      const TracedPath traced = trace_chain(mesh, resample(mesh, start, 30));
      const Straightened t = straighten(mesh, traced.path);
      check_result(mesh, traced.path, t);
      const Straightened again = straighten(mesh, s.path);  // a straight path stays as it is
      CHECK(again.final_length == Approx(s.final_length).epsilon(1e-12));
    }
  }
}

}  // namespace leastcost
