// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/straighten_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include "problems/mesh/trace.hpp"
#include "problems/section/plane_section.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

constexpr double kStraightRing = -1e-9;  // radians, what a certificate asks for
constexpr double kRounding = 1e-13;      // relative length: some 100 sums and square roots

/// The closed curve of a plane cut that is nearest to the point.
SurfacePath cut(const TriangleMesh& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const SectionCurves curves = section_curves(mesh, point, normal);
  REQUIRE_FALSE(curves.closed.empty());
  const auto distance = [&](const SurfacePath& path) {
    double best = 1e300;
    for (const Eigen::Vector3d& p : path.points) best = std::min(best, (p - point).norm());
    return best;
  };
  return *std::min_element(curves.closed.begin(), curves.closed.end(),
                           [&](const SurfacePath& a, const SurfacePath& b) { return distance(a) < distance(b); });
}

/// Everything that must hold for any straightened ring.
void check_result(const TriangleMesh& mesh, const SurfacePath& start, const StraightenedRing& s,
                  const MetricRoot& metric = {}) {
  REQUIRE(s.finished);
  REQUIRE(s.initial_length == Approx(path_length(start, metric)).epsilon(1e-14));
  REQUIRE(s.final_length <= s.initial_length * (1 + 1e-14));
  if (s.collapsed) {
    REQUIRE(s.path.faces.empty());
    return;
  }
  REQUIRE(s.path.points.front() == s.path.points.back());
  REQUIRE(lies_on(mesh, s.path));
  REQUIRE(s.final_length == Approx(path_length(s.path, metric)).epsilon(1e-14));
  REQUIRE(check_straight_ring(mesh, s.path, metric) >= kStraightRing);
}

StraightenOptions options_with(const MetricRoot& metric) {
  StraightenOptions options;
  options.metric = metric;
  return options;
}

/// Length of the straightened ring; 0: collapsed.
double ring_length(const TriangleMesh& mesh, const SurfacePath& start, const MetricRoot& metric = {}) {
  const StraightenedRing s = straighten_ring(mesh, start, options_with(metric));
  check_result(mesh, start, s, metric);
  return s.final_length;
}

TriangleMesh corner_box(double x, double y, double z, int subdivide) {
  PolygonSoup soup = test::cube();
  for (Eigen::Vector3d& p : soup.positions) p = p.cwiseProduct(Eigen::Vector3d(x, y, z));
  return TriangleMesh(soup, {false, subdivide});
}

/// A regular tetrahedron with edges of length 2 sqrt 2.
TriangleMesh tetrahedron(int subdivide) {
  PolygonSoup soup;
  soup.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})
    test::add_polygon(soup, {a, b, c});
  return TriangleMesh(soup, {false, subdivide});
}

/// Points beside the ring, up to `reach` off, joined again.
SurfacePath shaken(const TriangleMesh& mesh, const SurfacePath& ring, double reach, int count, test::Random& random) {
  std::vector<SurfacePoint> points = resample(mesh, ring, count);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    Eigen::Vector3d b = points[i].barycentric;
    for (int k = 0; k < 3; ++k) b[k] += reach * random.uniform(0, 1);
    points[i].barycentric = b / b.sum();
  }
  points.back() = points.front();
  return trace_chain(mesh, points).path;
}

SurfacePath begun_later(const SurfacePath& ring, std::size_t by) {
  SurfacePath path;
  const std::size_t count = ring.faces.size();
  path.points.push_back(ring.points[by % count]);
  for (std::size_t k = 0; k < count; ++k) {
    path.faces.push_back(ring.faces[(by + k) % count]);
    path.points.push_back(ring.points[(by + k) % count + 1]);
  }
  path.points.back() = path.points.front();
  return path;
}

}  // namespace

TEST_CASE("rings around boxes have the girth of the box") {
  for (int subdivide = 0; subdivide <= 3; ++subdivide) {
    const TriangleMesh mesh = corner_box(1, 2, 3, subdivide);
    CAPTURE(subdivide);
    for (const Eigen::Vector3d& tilt : {Eigen::Vector3d(0, 0, 0), {0.2, 0.1, 0}, {0.3, -0.4, 0}}) {
      CHECK(ring_length(mesh, cut(mesh, {0.01, 0.02, 0.3}, Eigen::Vector3d::UnitZ() + tilt)) ==
            Approx(6).epsilon(kRounding));
      CHECK(ring_length(mesh, cut(mesh, {0.01, 0.02, 0.3}, Eigen::Vector3d(tilt.x() / 3, 1, tilt.y() / 3))) ==
            Approx(8).epsilon(kRounding));
      CHECK(ring_length(mesh, cut(mesh, {0.01, 0.02, 0.3}, Eigen::Vector3d(1, tilt.x() / 6, tilt.y() / 6))) ==
            Approx(10).epsilon(kRounding));
    }
  }
}

TEST_CASE("closed geodesics of regular solids") {
  for (int subdivide = 0; subdivide <= 3; ++subdivide) {
    CAPTURE(subdivide);
    const TriangleMesh octahedron(test::octahedron(), {false, subdivide}), cube = corner_box(1, 1, 1, subdivide),
                                                                           tetra = tetrahedron(subdivide);
    // Sections parallel to a face of the octahedron, across a cube's space diagonal, parallel to two edges of the
    // tetrahedron: straight already, and any tilt is undone.
    for (const double tilt : {0.0, 0.05}) {
      const Eigen::Vector3d diagonal = Eigen::Vector3d::Ones() + tilt * Eigen::Vector3d(1, 0.3, -0.8);
      CHECK(ring_length(octahedron, cut(octahedron, {0.01, 0.02, 0.03}, diagonal)) ==
            Approx(3 * std::sqrt(2.0)).epsilon(kRounding));
      CHECK(ring_length(cube, cut(cube, {0.01, 0.02, 0.03}, diagonal)) ==
            Approx(3 * std::sqrt(2.0)).epsilon(kRounding));
      CHECK(ring_length(tetra, cut(tetra, {0.01, 0.02, 0.03}, Eigen::Vector3d(tilt, 1, -tilt))) ==
            Approx(4 * std::sqrt(2.0)).epsilon(kRounding));
    }
  }
}

TEST_CASE("a ring around one corner contracts") {
  for (int subdivide = 0; subdivide <= 3; ++subdivide) {
    CAPTURE(subdivide);
    const TriangleMesh cube = corner_box(1, 1, 1, subdivide), ball(test::sphere(subdivide));
    for (const double depth : {0.05, 0.2, 0.32}) {
      const StraightenedRing s = straighten_ring(cube, cut(cube, (0.5 - depth) * Eigen::Vector3d::Ones(), {1, 1, 1.1}));
      CHECK(s.collapsed);
      CHECK(s.final_length == 0);
    }
    CHECK(ring_length(ball, cut(ball, {0, 0, 0.3}, {0.1, 0.2, 1})) == 0);
  }
}

TEST_CASE("a ring around a hole settles on its border") {
  constexpr int kSides = 24;
  const TriangleMesh annulus(test::grid(kSides, 6, test::Closing::kRound, false));  // flat, radii 2 to 4
  std::vector<SurfacePoint> points;
  test::Random random;
  for (int i = 0; i <= kSides; ++i) {
    const std::int32_t v = annulus.vertex_of_file(7 * (i % kSides) + random.integer(0, 6) * (i % kSides ? 1 : 0));
    points.push_back(vertex_point(annulus, v));
  }
  const SurfacePath start = trace_chain(annulus, points).path;
  CHECK(ring_length(annulus, start) == Approx(2 * kSides * 2 * std::sin(std::numbers::pi / kSides)).epsilon(kRounding));
}

TEST_CASE("rings of a polyhedral torus") {
  constexpr int kAround = 16, kTube = 10;
  const TriangleMesh torus(test::grid(kAround, kTube, test::Closing::kRound, true));  // radii 3 and 1
  // Around the hole: the inner equator. A plane through the axis but tilted starts off it.
  const double equator = 2 * kAround * 2 * std::sin(std::numbers::pi / kAround);
  for (const double tilt : {0.0, 0.1, 0.2})
    CHECK(ring_length(torus, cut(torus, {-2, 0, 0}, {0.1 * tilt, tilt, 1})) == Approx(equator).epsilon(kRounding));
  // Around the tube: half way between two vertical sides, where the tube is thinnest.
  double meridian = 0;
  const auto section = [](int j) {
    const double a = 2 * std::numbers::pi * j / kTube;
    return Eigen::Vector2d((3 + std::cos(a)) * std::cos(std::numbers::pi / kAround), std::sin(a));
  };
  for (int j = 0; j < kTube; ++j) meridian += (section(j + 1) - section(j)).norm();
  for (const double tilt : {0.0, 0.1, 0.3})
    CHECK(ring_length(torus, cut(torus, {3, 0.5, 0}, {tilt, 1, 0.2 * tilt})) == Approx(meridian).epsilon(kRounding));
}

TEST_CASE("one-sided and flipped bands hold rings like any other") {
  constexpr int kAround = 20;
  const TriangleMesh moebius(test::grid(kAround, 4, test::Closing::kTwisted, false));
  // Five rows of vertices, of which the middle one closes on itself; zigzags of two heights start in one class.
  const auto zigzag = [&](int height) {
    std::vector<SurfacePoint> points;
    for (int i = 0; i <= kAround; ++i) {
      const int row = i % kAround == 0 ? 2 : 2 + (i % 2 ? height : 0);
      points.push_back(vertex_point(moebius, moebius.vertex_of_file(5 * (i % kAround) + row)));
    }
    return trace_chain(moebius, points).path;
  };
  const SurfacePath start = zigzag(1);
  const double once = ring_length(moebius, start);
  CHECK(once > 2 * 2 * std::numbers::pi);                                // all of it lies outside of this cylinder
  CHECK(once < 2 * 3 * kAround * std::sin(std::numbers::pi / kAround));  // the polygon of the middle row
  CHECK(ring_length(moebius, zigzag(-2)) == Approx(once).epsilon(kRounding));
  SurfacePath twice = start;
  twice.points.insert(twice.points.end(), start.points.begin() + 1, start.points.end());
  twice.faces.insert(twice.faces.end(), start.faces.begin(), start.faces.end());
  CHECK(ring_length(moebius, twice) <= 2 * once * (1 + kRounding));

  PolygonSoup soup = test::soup_of(corner_box(1, 2, 3, 1));
  for (std::size_t f = 0; f + 1 < soup.polygon_begin.size(); f += 3)
    std::swap(soup.corners[3 * f], soup.corners[3 * f + 1]);
  const TriangleMesh flipped(soup);
  CHECK(ring_length(flipped, cut(flipped, {0, 0, 0.1}, {0.1, 0.2, 1})) == Approx(6).epsilon(kRounding));
}

TEST_CASE("a ring may be begun anywhere, run backwards, scaled and shaken") {
  test::Random random;
  constexpr int kAround = 16, kTube = 10;
  const PolygonSoup soup = test::grid(kAround, kTube, test::Closing::kRound, true);
  const TriangleMesh torus(soup);
  const SurfacePath start = cut(torus, {-2, 0, 0.1}, {0.1, 0.15, 1});
  const double length = ring_length(torus, start);
  CHECK(ring_length(torus, reversed(start)) == Approx(length).epsilon(kRounding));
  for (std::size_t by = 1; by < start.faces.size(); by += 5)
    CHECK(ring_length(torus, begun_later(start, by)) == Approx(length).epsilon(kRounding));
  const StraightenedRing straight = straighten_ring(torus, start);
  for (int i = 0; i < 40; ++i) {
    const SurfacePath off = shaken(torus, straight.path, random.uniform(0.01, 0.5), random.integer(8, 60), random);
    CHECK(ring_length(torus, off) == Approx(length).epsilon(kRounding));
  }
  CHECK(ring_length(torus, straight.path) == Approx(length).epsilon(kRounding));
  PolygonSoup large = soup;
  for (Eigen::Vector3d& p : large.positions) p *= 1024;
  const TriangleMesh scaled(large);
  CHECK(ring_length(scaled, cut(scaled, {-2048, 0, 102.4}, {0.1, 0.15, 1})) ==
        Approx(1024 * length).epsilon(kRounding));
}

TEST_CASE("a constant metric is the Euclidean ring of the transformed mesh") {
  Eigen::Matrix3d root;
  root << 1, 0.2, 0.1, 0, 1.5, -0.3, 0, 0, 0.7;
  const PolygonSoup soup = test::grid(14, 9, test::Closing::kRound, true);
  PolygonSoup image = soup;
  for (Eigen::Vector3d& p : image.positions) p = root * p;
  const TriangleMesh mesh(soup), transformed(image);
  const SurfacePath start = cut(mesh, {3, 0.5, 0}, {0.2, 1, 0.1});
  SurfacePath moved = start;
  for (Eigen::Vector3d& p : moved.points) p = root * p;
  moved.points.back() = moved.points.front();
  CHECK(ring_length(mesh, start, root) == Approx(ring_length(transformed, moved)).epsilon(1e-12));
}

TEST_CASE("flips shorten a ring on a bumpy surface and never lose it") {
  test::Random random;
  for (int i = 0; i < 20; ++i) {
    PolygonSoup soup = test::grid(24, 16, test::Closing::kRound, true);
    for (Eigen::Vector3d& p : soup.positions) p += 0.08 * random.vector(3);
    const TriangleMesh torus(soup);
    for (const SurfacePath& start : {cut(torus, {3, 0.5, 0}, {0.3, 1, 0.1}), cut(torus, {-2, 0, 0}, {0, 0.1, 1})}) {
      StraightenOptions options;
      const double without = ring_length(torus, start);
      options.flips = true;
      const StraightenedRing s = straighten_ring(torus, start, options);
      check_result(torus, start, s);
      CHECK_FALSE(s.collapsed);
      CHECK(s.final_length <= without * (1 + kRounding));
    }
  }
}

TEST_CASE("the checker of rings looks at the seam") {
  const TriangleMesh mesh = corner_box(1, 2, 3, 1);
  const SurfacePath straight = straighten_ring(mesh, cut(mesh, {0, 0, 0.1}, {0.1, 0.2, 1})).path;
  CHECK(check_straight_ring(mesh, straight) >= kStraightRing);
  SurfacePath open = straight;
  open.points.pop_back();
  open.faces.pop_back();
  CHECK(check_straight(mesh, open) >= kStraightRing);
  CHECK(check_straight_ring(mesh, open) < -1);
  // Tilted cuts through flat sides turn at the box's edges only; one seam in the middle of a side must be seen as well.
  SurfacePath bent = begun_later(straight, 1);
  const Eigen::Vector3d off(0, 0, 0.1);
  bent.points.front() += off;
  bent.points.back() += off;
  CHECK(check_straight_ring(mesh, bent) < -0.01);
}

TEST_CASE("rings that are none, and interrupted ones") {
  const TriangleMesh mesh = corner_box(1, 2, 3, 3);
  const SurfacePath start = cut(mesh, {0, 0, 0.1}, {0.3, 0.4, 1});
  SurfacePath open = start;
  open.points.pop_back();
  open.faces.pop_back();
  CHECK_THROWS_AS(straighten_ring(mesh, open), InputError);
  StraightenOptions impatient;
  impatient.stop = [] { return true; };
  const StraightenedRing stopped = straighten_ring(mesh, start, impatient);
  CHECK_FALSE(stopped.finished);
  CHECK(lies_on(mesh, stopped.path));
  CHECK(stopped.path.points.front() == stopped.path.points.back());
  CHECK(stopped.final_length <= stopped.initial_length * (1 + 1e-14));
  SurfacePath there_and_back = open;
  const SurfacePath back = reversed(open);
  there_and_back.points.insert(there_and_back.points.end(), back.points.begin() + 1, back.points.end());
  there_and_back.faces.insert(there_and_back.faces.end(), back.faces.begin(), back.faces.end());
  CHECK(straighten_ring(mesh, there_and_back).collapsed);
}

}  // namespace leastcost
