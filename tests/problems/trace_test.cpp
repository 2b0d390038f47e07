// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/trace.hpp"

#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

SurfacePoint random_start(const TriangleMesh& mesh, test::Random& random) {
  Eigen::Vector3d b(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
  const int kind = random.integer(0, 3);  // inside faces, and now and then on edges and vertices
  if (kind == 0) b[random.integer(0, 2)] = 0;
  if (kind == 1) b = Eigen::Vector3d::Unit(random.integer(0, 2));
  return {random.integer(0, mesh.face_count() - 1), b / b.sum()};
}

void check_trace(const TriangleMesh& mesh, const std::vector<SurfacePoint>& chain, const TracedPath& traced) {
  REQUIRE(lies_on(mesh, traced.path));
  REQUIRE(traced.chain_points.size() == chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i)
    REQUIRE((traced.path.points[traced.chain_points[i]] - mesh.point(chain[i])).norm() <= 1e-11 * mesh.diameter());
  const TraceReport& r = traced.report;
  REQUIRE(r.direct + r.walked + r.cut + r.connected == static_cast<int>(chain.size()) - 1);
}

/// A path of graph moves between two points, sampled: a chain as a solver would leave it.
std::vector<SurfacePoint> chain_on(const TriangleMesh& mesh, EdgeGraphSearch& graph, const SurfacePoint& a,
                                   const SurfacePoint& b, int count) {
  const auto length = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return (q - p).norm(); };
  const EdgePath path = graph.shortest(a, b, length);
  return path.path.faces.empty() ? std::vector<SurfacePoint>{} : resample(mesh, path.path, count);
}

}  // namespace

TEST_CASE("on a flat mesh a trace is the straight line") {
  const TriangleMesh mesh(test::cube(), {false, 3});
  test::Random random;
  for (int i = 0; i < 200; ++i) {
    SurfacePoint a = random_start(mesh, random), b = random_start(mesh, random);
    if (mesh.file_face(a.face) != mesh.file_face(b.face)) continue;  // the same side of the cube
    const TracedPath traced = trace_chain(mesh, std::vector{a, b});
    check_trace(mesh, {a, b}, traced);
    CHECK(path_length(traced.path) == Approx((mesh.point(a) - mesh.point(b)).norm()).epsilon(1e-12).margin(1e-14));
    CHECK(traced.report.cut + traced.report.connected == 0);
  }
}

TEST_CASE("a chain of points on a sphere is traced by walking") {
  const TriangleMesh mesh(test::sphere(4));
  EdgeGraphSearch graph(mesh);
  const std::vector<SurfacePoint> chain = chain_on(mesh, graph, vertex_point(mesh, 0), vertex_point(mesh, 2), 12);
  const TracedPath traced = trace_chain(mesh, chain);
  check_trace(mesh, chain, traced);
  CHECK(traced.report.walked == 11);
}

TEST_CASE("opposite points of a sphere need the cutting plane") {
  const TriangleMesh mesh(test::sphere(3));
  const std::vector<SurfacePoint> chain{{0, {0.4, 0.35, 0.25}}, {0, {0, 0, 0}}};
  // The point whose projection falls inside the first face: straight below it.
  SurfacePoint below = chain[0];
  for (std::int32_t f = 0; f < mesh.face_count(); ++f)
    if (mesh.point({f, chain[0].barycentric}).dot(mesh.point(chain[0])) < mesh.point(below).dot(mesh.point(chain[0])))
      below = {f, chain[0].barycentric};
  const TracedPath traced = trace_chain(mesh, std::vector{chain[0], below});
  check_trace(mesh, {chain[0], below}, traced);
  CHECK(path_length(traced.path) < 1.2 * std::numbers::pi);
}

TEST_CASE("points on two sides of a gap are connected along edges") {
  // A strip bent into a hairpin: two parallel sheets 0.1 apart, joined at x = 10 only.
  PolygonSoup soup;
  for (int i = 0; i <= 20; ++i)
    for (const double y : {0.0, 1.0})
      soup.positions.emplace_back(i <= 10 ? i : 20 - i, y, i == 10 ? 0.05 : i < 10 ? 0.0 : 0.1);
  for (int i = 0; i < 20; ++i) test::add_polygon(soup, {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  const TriangleMesh mesh(soup);
  const std::vector<SurfacePoint> chain{{1, {0.3, 0.3, 0.4}}, {mesh.face_count() - 2, {0.3, 0.3, 0.4}}};
  const TracedPath traced = trace_chain(mesh, chain);
  check_trace(mesh, chain, traced);
  CHECK(path_length(traced.path) > 18);
}

TEST_CASE("flipped faces and one-sided surfaces change nothing") {
  PolygonSoup soup = test::soup_of(TriangleMesh(test::sphere(3)));
  const TriangleMesh mesh(soup);
  for (std::size_t f = 0; f + 1 < soup.polygon_begin.size(); f += 2)
    std::swap(soup.corners[3 * f], soup.corners[3 * f + 1]);
  const TriangleMesh flipped(soup);
  const std::vector<SurfacePoint> chain{vertex_point(mesh, 0), vertex_point(mesh, 2), vertex_point(mesh, 4)};
  const std::vector<SurfacePoint> same{vertex_point(flipped, 0), vertex_point(flipped, 2), vertex_point(flipped, 4)};
  const TracedPath a = trace_chain(mesh, chain), b = trace_chain(flipped, same);
  check_trace(flipped, same, b);
  CHECK(path_length(b.path) == Approx(path_length(a.path)).epsilon(1e-12));

  const TriangleMesh band(test::grid(40, 6, test::Closing::kTwisted, false));
  EdgeGraphSearch graph(band);
  test::Random random;
  for (int i = 0; i < 50; ++i) {
    const std::vector<SurfacePoint> points =
        chain_on(band, graph, random_start(band, random), random_start(band, random), 9);
    if (!points.empty()) check_trace(band, points, trace_chain(band, points));
  }
}

TEST_CASE("ends in different parts are an input error") {
  PolygonSoup soup = test::cube();
  const PolygonSoup other = test::cube();
  for (const Eigen::Vector3d& p : other.positions) soup.positions.emplace_back(p + Eigen::Vector3d(3, 0, 0));
  test::add_polygon(soup, {8, 9, 11, 10});
  const TriangleMesh mesh(soup);
  REQUIRE_THROWS_AS(trace_chain(mesh, std::vector{vertex_point(mesh, 0), vertex_point(mesh, 9)}), InputError);
}

TEST_CASE("traces on real meshes are connected face by face") {
  test::Random random;
  for (const char* name :
       {"meshes/duck.obj", "meshes/lion.off", "meshes/knot1.off", "meshes/moebius.obj", "meshes/hourglass.obj",
        "meshes/horse_dirty.obj", "meshes/double-torus_tri.off", "meshes/cow.off"}) {
    const auto file = test::data_file(name);
    if (!file) continue;
    CAPTURE(name);
    const TriangleMesh mesh(read_mesh(*file));
    EdgeGraphSearch graph(mesh);
    for (int i = 0; i < 20; ++i) {
      const SurfacePoint a = random_start(mesh, random), b = random_start(mesh, random);
      if (mesh.component(mesh.face(a.face)[0]) != mesh.component(mesh.face(b.face)[0])) continue;
      const std::vector<SurfacePoint> chain = chain_on(mesh, graph, a, b, random.integer(2, 60));
      if (!chain.empty()) check_trace(mesh, chain, trace_chain(mesh, chain));
      const std::vector<SurfacePoint> far{a, b};  // as bad a chain as can be
      check_trace(mesh, far, trace_chain(mesh, far));
    }
  }
}

TEST_CASE("resampling is equal in length and keeps the ends") {
  const TriangleMesh mesh(test::sphere(3));
  EdgeGraphSearch graph(mesh);
  const auto length = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return (q - p).norm(); };
  const SurfacePath path = graph.shortest(vertex_point(mesh, 0), vertex_point(mesh, 3), length).path;
  const std::vector<SurfacePoint> samples = resample(mesh, path, 9);
  REQUIRE(samples.size() == 9);
  CHECK(mesh.point(samples.front()) == path.points.front());
  CHECK(mesh.point(samples.back()) == path.points.back());
  const TracedPath traced = trace_chain(mesh, samples);
  CHECK(path_length(traced.path) <= path_length(path) * (1 + 1e-12));
  CHECK(path_length(reversed(path)) == Approx(path_length(path)).epsilon(1e-14));
  REQUIRE_THROWS_AS(resample(mesh, path, 1), InputError);
  SurfacePath broken = path;
  broken.points[1] += Eigen::Vector3d(0, 0, 1e-6);
  CHECK(!lies_on(mesh, broken));
}

}  // namespace leastcost
