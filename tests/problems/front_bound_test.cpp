// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/front_bound.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "problems/exact/lower_bound.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

constexpr double kRounding = 1e-12;  // relative

enum class Surface { bumps, sphere, box, pages, uneven };

/// Of one to four thousand vertices; fronts are six edges apart.
TriangleMesh surface(Random& random, Surface kind) {
  const auto height = [&] { return random.uniform(-0.4, 0.4); };
  switch (kind) {
    case Surface::bumps: {  // with holes
      const PolygonSoup all = sheet(
          40, 30, [&](double u, double v) { return Eigen::Vector3d(40 * u, 30 * v, 6 * std::sin(12 * u) + height()); });
      PolygonSoup soup;
      soup.positions = all.positions;
      for (std::size_t c = 0; c < all.corners.size(); c += 3)
        if (random.uniform(0, 1) > 0.02) add_polygon(soup, {all.corners[c], all.corners[c + 1], all.corners[c + 2]});
      return TriangleMesh(soup);
    }
    case Surface::sphere: return TriangleMesh(sphere(5));
    case Surface::box: return TriangleMesh(cube(), {.subdivide = 4});
    case Surface::pages: {  // three sheets that share the edges of one side
      PolygonSoup soup;
      constexpr int kWide = 16, kHigh = 24;
      for (int j = 0; j <= kHigh; ++j) soup.positions.emplace_back(0, j, 0);
      for (int page = 0; page < 3; ++page) {
        const double angle = 2.1 * page;
        const auto at = [&](int i, int j) { return i == 0 ? j : (kHigh + 1) * (1 + page * kWide + i - 1) + j; };
        for (int i = 1; i <= kWide; ++i)
          for (int j = 0; j <= kHigh; ++j)
            soup.positions.emplace_back(i * std::cos(angle), j + 0.3 * height(), i * std::sin(angle) + height());
        for (int i = 0; i < kWide; ++i)
          for (int j = 0; j < kHigh; ++j) {
            add_polygon(soup, {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            add_polygon(soup, {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
          }
      }
      return TriangleMesh(soup);
    }
    case Surface::uneven: break;
  }
  // Cells that grow by a factor of 30 across, and long edges beside short ones.
  return TriangleMesh(sheet(60, 40, [&](double u, double v) {
    return Eigen::Vector3d(std::exp(3.5 * u), 12 * v, 8 * std::cos(12 * u) + height());
  }));
}

SurfacePoint random_end(Random& random, const TriangleMesh& mesh) {
  if (random.integer(0, 1) == 0) return vertex_point(mesh, random.integer(0, mesh.vertex_count() - 1));
  const double a = random.uniform(0, 0.5), b = random.integer(0, 1) == 0 ? 0 : random.uniform(0, 0.5);
  return {random.integer(0, mesh.face_count() - 1), Eigen::Vector3d(1 - a - b, a, b)};
}

}  // namespace

TEST_CASE("fronts: no bound is above the length of a path that counts") {
  const Surface kind = GENERATE(Surface::bumps, Surface::sphere, Surface::box, Surface::pages, Surface::uneven);
  CAPTURE(static_cast<int>(kind));
  Random random(5 + static_cast<int>(kind));
  const TriangleMesh mesh = surface(random, kind);
  const HalfEdges edges(mesh);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  FrontBound fronts(edges);
  int vertices = 0, helped = 0, above = 0, on_edges = 0, above_on_edges = 0;
  for (int k = 0; k < trials(12); ++k) {
    const SurfacePoint source = random_end(random, mesh), target = random_end(random, mesh);
    const EndPoint from = end_point(edges, source), to = end_point(edges, target);
    const double length = search.shortest(source, target, workspace).length;
    if (std::isinf(length)) continue;
    const ExactDistances there = search.distances(source, workspace), back = search.distances(target, workspace);
    const double upper = length * (1 + std::vector<double>{1e-12, 0.02, 0.5}[static_cast<std::size_t>(k % 3)]);
    const LowerBound to_source(edges, &from, nullptr);
    fronts.aim(from, to, upper, [&](std::int32_t v) { return to_source.from_vertex(v); });
    const LowerBound straight(edges, &to, nullptr);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      const std::size_t i = static_cast<std::size_t>(v);
      if (!(there.distance[i] + back.distance[i] < upper)) continue;
      ++vertices;
      const double bound = fronts.from_vertex(v);
      if (bound > back.distance[i] * (1 + kRounding)) ++above;
      if (bound > straight.from_vertex(v)) ++helped;
    }
    for (int e = 0; e < 40; ++e) {
      const std::int32_t h = random.integer(0, 3 * mesh.face_count() - 1);
      const auto at_ends = fronts.along(h);
      if (!at_ends) continue;
      const double share = random.uniform(0, 1);
      SurfacePoint between{h / 3, Eigen::Vector3d::Zero()};
      between.barycentric[h % 3] = 1 - share;
      between.barycentric[(h + 1) % 3] = share;
      const double to_target = search.shortest(between, target, workspace).length;
      if (!(to_target + search.shortest(source, between, workspace).length < upper)) continue;
      ++on_edges;
      if ((1 - share) * at_ends->first + share * at_ends->second > to_target * (1 + kRounding)) ++above_on_edges;
    }
  }
  CHECK(above == 0);
  CHECK(above_on_edges == 0);
  CHECK(vertices > 100);
  CHECK(on_edges > 0);
  CHECK(helped > 0);
}

/// Round a sphere the straight line is far off: over a diameter by a third.
TEST_CASE("fronts: on a sphere they come near to the distance where the straight line does not") {
  const TriangleMesh mesh(sphere(5));
  const HalfEdges edges(mesh);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const ExactDistances all = search.distances(vertex_point(mesh, 0), workspace);
  std::int32_t far = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
    if (all.distance[static_cast<std::size_t>(v)] > all.distance[static_cast<std::size_t>(far)]) far = v;
  const double length = all.distance[static_cast<std::size_t>(far)];
  FrontBound fronts(edges);
  const EndPoint from = end_point(edges, vertex_point(mesh, far)), to = end_point(edges, vertex_point(mesh, 0));
  const LowerBound back(edges, &from, nullptr);
  fronts.aim(from, to, length * (1 + 1e-9), [&](std::int32_t v) { return back.from_vertex(v); });
  CHECK((mesh.position(far) - mesh.position(0)).norm() < 0.65 * length);
  CHECK(fronts.from_vertex(far) > 0.97 * length);
}

/// A strip that can be unrolled: all bounds are near to the distance, and all keys alike.
TEST_CASE("fronts: on a long strip they take no more windows than the straight line") {
  Random random(11);
  const TriangleMesh mesh(sheet(1000, 4, [&](double u, double v) {
    return Eigen::Vector3d(300 * u, 3 * v, std::sin(60 * u) + 0.01 * random.uniform(-1, 1));
  }));
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  std::int64_t with = 0, without = 0;
  for (int k = 0; k < 3; ++k) {
    const SurfacePoint source = vertex_point(mesh, random.integer(0, 1500));
    const SurfacePoint target = vertex_point(mesh, mesh.vertex_count() - 1 - random.integer(0, 1500));
    const ExactResult found = search.shortest(source, target, workspace);
    CHECK(found.is_proved());
    with += found.windows;
    without += search.shortest(source, target, workspace, {.fronts = false}).windows;
  }
  CHECK(10 * with < 13 * without);
}

TEST_CASE("fronts: in any unit a path is proved") {
  const double unit = GENERATE(1e-25, 1e-14, 1e14, 1e25);
  CAPTURE(unit);
  PolygonSoup soup = sphere(4);
  for (Eigen::Vector3d& p : soup.positions) p *= unit;
  const TriangleMesh mesh(soup);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const SurfacePoint source = vertex_point(mesh, 3), target = vertex_point(mesh, mesh.vertex_count() - 5);
  const ExactResult found = search.shortest(source, target, workspace);
  CHECK(found.is_proved());
  CHECK(found.length == Approx(search.shortest(source, target, workspace, {.fronts = false}).length).epsilon(1e-12));
}

TEST_CASE("fronts: with any start the same path is proved, by fewer windows") {
  const Surface kind = GENERATE(Surface::bumps, Surface::sphere, Surface::pages, Surface::uneven);
  CAPTURE(static_cast<int>(kind));
  Random random(50 + static_cast<int>(kind));
  const TriangleMesh mesh = surface(random, kind);
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  EdgeGraphSearch graph(mesh);
  const auto length_of = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); };
  std::int64_t with = 0, without = 0;
  for (int k = 0; k < trials(20); ++k) {
    const SurfacePoint source = random_end(random, mesh), target = random_end(random, mesh);
    const ExactResult plain = search.shortest(source, target, workspace);
    if (plain.path.points.size() < 2) continue;
    const SurfacePath on_edges = graph.shortest(source, target, length_of, {}).path;
    for (const SurfacePath* start : {&plain.path, &on_edges}) {
      const ExactResult quick = search.shortest(source, target, workspace, {.start = start});
      const ExactResult slow = search.shortest(source, target, workspace, {.start = start, .fronts = false});
      CHECK(quick.is_proved());
      CHECK(quick.length == Approx(plain.length).epsilon(1e-9));
      CHECK(quick.lower_bound <= plain.length * (1 + kRounding));
      CHECK(quick.lower_bound >= plain.length * (1 - 1e-9));
      with += quick.windows;
      without += slow.windows;
    }
  }
  CHECK(with < without);
}

}  // namespace leastcost::test
