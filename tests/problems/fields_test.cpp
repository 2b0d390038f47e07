// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Distances by fast marching and by heat against closed forms: the plane, the unit sphere, a cylinder's strip.
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/fields/descent.hpp>
#include <leastcost/problems/fields/fast_marching.hpp>
#include <leastcost/problems/fields/heat.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Field = std::vector<double>;

Field marched(const TriangleMesh& mesh, const SurfacePoint& source) { return fast_marching_distances(mesh, source); }
Field heated(const TriangleMesh& mesh, const SurfacePoint& source) { return heat_distances(mesh, source); }

/// Root mean square error in units of the largest distance, against great circles from the north pole (vertex 4).
double sphere_error(int levels, Field (*make)(const TriangleMesh&, const SurfacePoint&)) {
  const TriangleMesh mesh(sphere(levels));
  const Field field = make(mesh, vertex_point(mesh, 4));
  double sum = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const double angle = std::acos(std::clamp(mesh.position(v).z(), -1.0, 1.0));
    sum += std::pow(field[static_cast<std::size_t>(v)] - angle, 2);
  }
  return std::sqrt(sum / mesh.vertex_count()) / std::numbers::pi;
}

/// A flat sheet whose faces are sheared until their angles are obtuse.
TriangleMesh sheared(int n) {
  return TriangleMesh(sheet(n, n, [](double u, double v) { return Eigen::Vector3d(u - 1.5 * v, v, 0); }));
}

}  // namespace

TEST_CASE("fields: of order one in the edges on the sphere") {
  for (auto* make : {&marched, &heated}) {
    const double coarse = sphere_error(3, make), fine = sphere_error(5, make);
    CAPTURE(coarse, fine);
    CHECK(coarse < 0.05);
    CHECK(fine < 0.6 * coarse);  // a quarter for order one, but for the source: h log h
  }
}

TEST_CASE("fields: a plane wave is marched exactly along edges, and never below the straight line") {
  const TriangleMesh mesh(sheet(16, 16, [](double u, double v) { return Eigen::Vector3d(u, v, 0); }));
  const Field field = marched(mesh, vertex_point(mesh, 0));
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Vector3d& p = mesh.position(v);
    const double d = field[static_cast<std::size_t>(v)];
    CHECK(d >= p.norm() - 1e-12);
    CHECK(d <= p.norm() + 0.05);
    if (p.x() == 0 || p.y() == 0) CHECK(d == Approx(p.norm()).margin(1e-12));
  }
}

TEST_CASE("fields: obtuse corners get virtual edges, Delaunay edges") {
  // Without, the error of fast marching on such faces does not fall with the mesh.
  for (auto* make : {&marched, &heated}) {
    double errors[2];
    for (int level = 0; level < 2; ++level) {
      const int n = level == 0 ? 16 : 64;
      const TriangleMesh mesh = sheared(n);
      const std::int32_t middle = (n / 2) * (n + 1) + n / 2;
      const Field field = make(mesh, vertex_point(mesh, middle));
      double sum = 0;
      for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
        sum += std::abs(field[static_cast<std::size_t>(v)] - (mesh.position(v) - mesh.position(middle)).norm());
      errors[level] = sum / mesh.vertex_count();
    }
    CAPTURE(errors[0], errors[1]);
    CHECK(errors[1] < 0.5 * errors[0]);
  }
  HeatOptions plain;
  CHECK(HeatDistances(sheared(8), plain).flips() > 0);
  plain.delaunay = false;
  CHECK(HeatDistances(sheared(8), plain).flips() == 0);
}

TEST_CASE("fields: sources inside faces, other components, a target, a stop") {
  PolygonSoup two = sphere(2);
  const PolygonSoup other = sphere(1);
  const auto shift = static_cast<std::int32_t>(two.positions.size());
  for (const Eigen::Vector3d& p : other.positions) two.positions.push_back(p + Eigen::Vector3d(5, 0, 0));
  for (std::size_t i = 0; i + 2 < other.corners.size(); i += 3)
    add_polygon(two, {shift + other.corners[i], shift + other.corners[i + 1], shift + other.corners[i + 2]});
  const TriangleMesh mesh(two);
  const SurfacePoint source{10, Eigen::Vector3d(0.2, 0.5, 0.3)};
  for (auto* make : {&marched, &heated}) {
    const Field field = make(mesh, source);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const double d = field[static_cast<std::size_t>(v)];
      if (v >= shift) {
        CHECK(d == std::numeric_limits<double>::infinity());
      } else {
        CHECK(std::abs(d - std::acos(std::clamp(mesh.position(v).dot(mesh.point(source).normalized()), -1.0, 1.0))) <
              0.3);
      }
    }
  }
  const std::int32_t near = mesh.face(10)[1];
  const Field some = fast_marching_distances(mesh, source, {near, {}});
  CHECK(some[static_cast<std::size_t>(near)] == Approx((mesh.position(near) - mesh.point(source)).norm()));
  CHECK(std::count(some.begin(), some.end(), std::numeric_limits<double>::infinity()) > shift / 2);
  HeatOptions stopped;
  stopped.stop = [] { return true; };
  CHECK_THROWS_AS(heat_distances(mesh, source, stopped), Interrupted);
}

TEST_CASE("fields: paths down a field are on the mesh and no shorter than the shortest") {
  const TriangleMesh mesh(sphere(3));
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const SurfacePoint source{3, Eigen::Vector3d(0.3, 0.3, 0.4)};
  for (auto* make : {&marched, &heated}) {
    const Field field = make(mesh, source);
    for (std::int32_t f = 1; f < mesh.face_count(); f += 37) {
      const SurfacePoint start{f, Eigen::Vector3d(0.5, 0.25, 0.25)};
      const Descent descent = descend(mesh, field, start, source);
      CAPTURE(f);
      REQUIRE_FALSE(descent.path.points.empty());
      CHECK(lies_on(mesh, descent.path));
      CHECK(descent.path.points.front() == mesh.point(start));
      CHECK((descent.path.points.back() - mesh.point(source)).norm() < 1e-14);
      const double exact = search.shortest(start, source, workspace).length;
      CHECK(path_length(descent.path) >= exact * (1 - 1e-12));
      CHECK(path_length(descent.path) <= exact * 1.1);
    }
  }
}

TEST_CASE("fields: a field with minima of its own still leads to the source") {
  const TriangleMesh mesh(sphere(2));
  const Field flat(static_cast<std::size_t>(mesh.vertex_count()), 1.0);
  const Descent descent = descend(mesh, flat, vertex_point(mesh, 0), vertex_point(mesh, 1));
  CHECK(descent.by_edges);
  CHECK(lies_on(mesh, descent.path));
  CHECK(descent.path.points.back() == mesh.position(1));
  CHECK_THROWS_WITH(descend(mesh, Field(3), vertex_point(mesh, 0), vertex_point(mesh, 1)),
                    Catch::Contains("give one per vertex"));
}

TEST_CASE("fields: what heat cannot do is said") {
  PolygonSoup fan;  // three faces on one edge
  fan.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  add_polygon(fan, {0, 1, 2});
  add_polygon(fan, {0, 1, 3});
  add_polygon(fan, {0, 1, 4});
  CHECK_THROWS_WITH(HeatDistances(TriangleMesh(fan)), Catch::Contains("vertices 0 and 1 has three or more faces"));
  HeatOptions options;
  options.time = 0;
  CHECK_THROWS_AS(HeatDistances(TriangleMesh(sphere(1)), options), OptionError);
}

}  // namespace leastcost::test
