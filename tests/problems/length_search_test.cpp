// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/length_search.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include "problems/mesh/choose_landmarks.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// A sphere with dents, so that no two routes are equally long.
TriangleMesh dented_sphere(Random& random) {
  PolygonSoup soup = sphere(4);
  for (Eigen::Vector3d& p : soup.positions) p *= random.uniform(0.9, 1.1);
  return TriangleMesh(soup);
}

/// A quarter of them are vertices.
SurfacePoint any_point(Random& random, const TriangleMesh& mesh) {
  if (random.integer(0, 3) == 0) return vertex_point(mesh, random.integer(0, mesh.vertex_count() - 1));
  double a = random.uniform(0, 1), b = random.uniform(0, 1);
  if (a + b > 1) a = 1 - a, b = 1 - b;
  return {random.integer(0, mesh.face_count() - 1), Eigen::Vector3d(1 - a - b, a, b)};
}

Eigen::Matrix3d shear() {
  Eigen::Matrix3d root;
  root << 1, 0.3, 0, 0, 2, 0.2, 0, 0, 0.5;
  return root;
}

}  // namespace

TEST_CASE("length search: the lengths of the search that asks for every move, with landmarks and without") {
  Random random;
  const TriangleMesh mesh = dented_sphere(random);
  EdgeGraphSearch by_moves(mesh);
  LengthSearch search(mesh);
  const EdgeLandmarks marks = choose_landmarks(mesh, 6);
  REQUIRE(marks.count() == 6);
  const MoveCost length = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); };
  int settled = 0, settled_aimed = 0;
  for (int k = 0; k < 150; ++k) {
    const SurfacePoint from = any_point(random, mesh), to = any_point(random, mesh);
    for (const bool diagonals : {false, true}) {
      CAPTURE(k, diagonals);
      EdgePathOptions options;
      options.diagonals = diagonals;
      const EdgePath expected = by_moves.shortest(from, to, length, options);
      const EdgePath alone = search.shortest(from, to, {.diagonals = diagonals});
      const EdgePath aimed = search.shortest(from, to, {.diagonals = diagonals, .landmarks = &marks});
      for (const EdgePath* path : {&alone, &aimed}) {
        REQUIRE(path->found());
        CHECK(path->cost == Approx(expected.cost).epsilon(1e-12).margin(1e-14));
        CHECK(path_length(path->path) == Approx(path->cost).epsilon(1e-12).margin(1e-14));
        CHECK(lies_on(mesh, path->path));
        CHECK(path->path.points.front().isApprox(mesh.point(from)));
        CHECK(path->path.points.back().isApprox(mesh.point(to)));
        CHECK(path->source_component_size == mesh.vertex_count());
      }
      CHECK(alone.settled <= expected.settled);
      CHECK(aimed.settled <= alone.settled);
      settled += alone.settled;
      settled_aimed += aimed.settled;
    }
  }
  CHECK(10 * settled_aimed < 9 * settled);
}

TEST_CASE("length search: on a large mesh it finds the lengths of the search that asks for every move") {
  Random random;
  PolygonSoup soup = sphere(4);
  for (Eigen::Vector3d& p : soup.positions) p *= random.uniform(0.9, 1.1);
  MeshOptions finer;
  finer.subdivide = 3;
  const TriangleMesh mesh(soup, finer);
  REQUIRE(mesh.vertex_count() > 65536);  // vertices are numbered in patches, and memory is asked for early
  EdgeGraphSearch by_moves(mesh);
  LengthSearch search(mesh);
  const MoveCost length = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); };
  for (int k = 0; k < 3; ++k) {
    const std::int32_t v = random.integer(0, mesh.vertex_count() - 1), w = random.integer(0, mesh.vertex_count() - 1);
    const std::vector<double> all = search.lengths_from(v);
    const SurfacePoint from = vertex_point(mesh, v), to = vertex_point(mesh, w);
    for (const bool diagonals : {false, true}) {
      CAPTURE(k, diagonals);
      EdgePathOptions options;
      options.lower_bound = [goal = mesh.position(w)](const Eigen::Vector3d& p) { return (goal - p).norm(); };
      options.diagonals = diagonals;
      const EdgePath expected = by_moves.shortest(from, to, length, options);
      const EdgePath found = search.shortest(from, to, {.diagonals = diagonals});
      REQUIRE(found.found());
      CHECK(found.cost == Approx(expected.cost).epsilon(1e-6));
      CHECK(lies_on(mesh, found.path));
      if (diagonals) CHECK(all[static_cast<std::size_t>(w)] == Approx(found.cost).epsilon(1e-6));
    }
  }
}

TEST_CASE("length search: a constant metric is the Euclidean one on a mesh that was turned") {
  Random random;
  const TriangleMesh mesh = dented_sphere(random);
  PolygonSoup soup = soup_of(mesh);
  for (Eigen::Vector3d& p : soup.positions) p = shear() * p;
  const TriangleMesh turned(soup);
  LengthSearch search(mesh), there(turned);
  const EdgeLandmarks marks = choose_landmarks(mesh, 4, MetricRoot(shear()));
  for (int k = 0; k < 50; ++k) {
    const SurfacePoint from = any_point(random, mesh), to = any_point(random, mesh);
    const EdgePath expected = there.shortest(from, to, {.diagonals = true});
    for (const EdgeLandmarks* given : {static_cast<const EdgeLandmarks*>(nullptr), &marks}) {
      const EdgePath found =
          search.shortest(from, to, {.metric = MetricRoot(shear()), .diagonals = true, .landmarks = given});
      CHECK(found.cost == Approx(expected.cost).epsilon(1e-12).margin(1e-14));
      CHECK(path_length(found.path, MetricRoot(shear())) == Approx(found.cost).epsilon(1e-12).margin(1e-14));
      CHECK(lies_on(mesh, found.path));
    }
  }
}

TEST_CASE("length search: landmarks bound every length from below, and are far apart") {
  Random random;
  const TriangleMesh mesh = dented_sphere(random);
  LengthSearch search(mesh);
  const EdgeLandmarks marks = choose_landmarks(mesh, 5);
  const auto difference = [&](std::int32_t i, std::int32_t a, std::int32_t b) {
    const auto k = static_cast<std::size_t>(i);
    return std::abs(static_cast<double>(marks.of(a)[k]) - static_cast<double>(marks.of(b)[k]));
  };
  for (const std::int32_t from : {0, 17, 200}) {
    const std::vector<double> all = search.lengths_from(from);
    for (std::int32_t v = 0; v < mesh.vertex_count(); v += 7) {
      const double length = all[static_cast<std::size_t>(v)];
      CHECK(length == Approx(search.shortest(vertex_point(mesh, from), vertex_point(mesh, v), {.diagonals = true}).cost)
                          .epsilon(1e-7)
                          .margin(1e-14));
      for (std::int32_t i = 0; i < marks.count(); ++i) CHECK(difference(i, from, v) <= length + 1e-6);
    }
  }
  for (std::int32_t i = 0; i < marks.count(); ++i) {
    int zeros = 0;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) zeros += marks.of(v)[static_cast<std::size_t>(i)] == 0;
    CHECK(zeros == 1);
  }
}

TEST_CASE("length search: two components, a stop, fewer vertices than landmarks") {
  PolygonSoup soup = cube();
  const auto first = static_cast<std::int32_t>(soup.positions.size());
  for (int k = 0; k < 3; ++k) soup.positions.emplace_back(5 + (k == 1), k == 2, 0);
  add_polygon(soup, {first, first + 1, first + 2});
  const TriangleMesh mesh(soup);
  LengthSearch search(mesh);
  const EdgeLandmarks marks = choose_landmarks(mesh, 100);
  CHECK(marks.count() > 1);
  CHECK(marks.count() <= first);
  CHECK(std::isinf(marks.of(first).front()));
  const EdgePath apart = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, first), {.landmarks = &marks});
  CHECK(apart.outcome == EdgePathOutcome::different_components);
  CHECK_THAT(apart.failure(), Catch::Contains("with 8 and 3 vertices"));
  const EdgePath beside =
      search.shortest(vertex_point(mesh, first), vertex_point(mesh, first + 1), {.landmarks = &marks});
  CHECK(beside.cost == Approx(1));
  const EdgePath same = search.shortest(vertex_point(mesh, 3), vertex_point(mesh, 3));
  CHECK(same.cost == 0);

  Random random;
  const TriangleMesh large = dented_sphere(random);
  LengthSearch stopped(large);
  const SurfacePoint from = vertex_point(large, 0), to = vertex_point(large, large.vertex_count() - 1);
  const EdgePath none = stopped.shortest(from, to, {.stop = [] { return true; }});
  CHECK((none.found() || none.outcome == EdgePathOutcome::stopped));
  CHECK(stopped.shortest(from, to).found());  // the next query is not disturbed
  CHECK(choose_landmarks(large, 3, {}, [] { return true; }).count() == 0);
}

TEST_CASE("dijkstra with diagonals and landmarks: as short as can be, for costs that are lengths on a mesh") {
  Random random;
  const auto domain = std::make_shared<const MeshManifold>(dented_sphere(random));
  const TriangleMesh& mesh = domain->mesh();
  const auto end = [&](std::int32_t v) { return PathEnd{mesh.position(v), vertex_point(mesh, v).face}; };
  Problem problem{domain, make_euclidean_cost(3), make_kernel<Expm1Square>(), end(0), end(200)};
  const DijkstraInitializer edges, diagonals({.diagonals = true}), aimed({.diagonals = true, .landmarks = 4});
  const auto length = [&](const DijkstraInitializer& initializer) {
    const Points x = initializer.first_path(problem, {}).path.u;
    return (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().sum();
  };
  for (const std::int32_t target : {200, 11, 150}) {
    problem.target = end(target);
    CHECK(length(diagonals) < length(edges));
    CHECK(length(aimed) == Approx(length(diagonals)).epsilon(1e-12));
  }
  CHECK_THROWS_AS(DijkstraInitializer({.rank = 2, .diagonals = true}).first_path(problem, {}), OptionError);
  problem.cost = make_travel_time_cost({.gravity = 1, .start_speed = 3}, 3, problem.source.u);
  CHECK_THROWS_WITH(aimed.first_path(problem, {}), Catch::Contains("constant metric"));
}

}  // namespace leastcost::test
