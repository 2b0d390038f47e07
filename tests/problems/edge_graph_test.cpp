// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/edge_graph.hpp>

#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double length(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); }

/// Uphill costs three times its length.
double climbing(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return length(a, b) + 2 * std::max(0.0, b.z() - a.z());
}

EdgePathOptions towards(const Eigen::Vector3d& goal) {
  EdgePathOptions options;
  options.lower_bound = [goal](const Eigen::Vector3d& p) { return (goal - p).norm(); };
  return options;
}

/// All least costs from one vertex by Bellman and Ford's rounds: slow, and nothing in common with the code under test.
std::vector<double> all_costs(const TriangleMesh& mesh, std::int32_t from, const MoveCost& cost) {
  std::vector<double> best(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
  best[static_cast<std::size_t>(from)] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      for (const std::int32_t w : mesh.neighbours(v)) {
        const double c = best[static_cast<std::size_t>(v)] + cost(mesh.position(v), mesh.position(w));
        if (c < best[static_cast<std::size_t>(w)]) best[static_cast<std::size_t>(w)] = c, changed = true;
      }
    }
  }
  return best;
}

double cost_along(const SurfacePath& path, const MoveCost& cost) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < path.points.size(); ++i) sum += cost(path.points[i], path.points[i + 1]);
  return sum;
}

/// Two tetrahedra that do not touch.
TriangleMesh two_parts() {
  PolygonSoup soup;
  for (const double x : {0.0, 5.0}) {
    const std::int32_t v = static_cast<std::int32_t>(soup.positions.size());
    for (const Eigen::Vector3d& p :
         {Eigen::Vector3d(x, 0, 0), Eigen::Vector3d(x + 1, 0, 0), Eigen::Vector3d(x, 1, 0), Eigen::Vector3d(x, 0, 1)})
      soup.positions.push_back(p);
    test::add_polygon(soup, {v, v + 2, v + 1});
    test::add_polygon(soup, {v, v + 1, v + 3});
    test::add_polygon(soup, {v, v + 3, v + 2});
    test::add_polygon(soup, {v + 1, v + 2, v + 3});
  }
  return TriangleMesh(soup);
}

}  // namespace

TEST_CASE("shortest edge paths are those of Bellman and Ford, symmetric and asymmetric costs") {
  const TriangleMesh mesh(test::sphere(3));
  EdgeGraphSearch search(mesh);
  for (const MoveCost& cost : {MoveCost(length), MoveCost(climbing)}) {
    const std::vector<double> expected = all_costs(mesh, 0, cost);
    for (std::int32_t v = 1; v < mesh.vertex_count(); v += 7) {
      const EdgePath dijkstra = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, v), cost);
      const EdgePath a_star =
          search.shortest(vertex_point(mesh, 0), vertex_point(mesh, v), cost, towards(mesh.position(v)));
      REQUIRE(dijkstra.found());
      REQUIRE(dijkstra.cost == Approx(expected[static_cast<std::size_t>(v)]).epsilon(1e-14));
      REQUIRE(a_star.cost == Approx(dijkstra.cost).epsilon(1e-14));
      REQUIRE(cost_along(a_star.path, cost) == Approx(a_star.cost).epsilon(1e-13));
      REQUIRE(a_star.settled <= dijkstra.settled);
      REQUIRE(lies_on(mesh, a_star.path));
      REQUIRE(a_star.vertices.front() == 0);
      REQUIRE(a_star.vertices.back() == v);
    }
  }
}

TEST_CASE("diagonals never make a graph path dearer, and lie on the surface") {
  const TriangleMesh mesh(test::sphere(3));
  EdgeGraphSearch search(mesh);
  for (std::int32_t v = 1; v < mesh.vertex_count(); v += 11) {
    EdgePathOptions options = towards(mesh.position(v));
    const EdgePath edges = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, v), length, options);
    options.diagonals = true;
    const EdgePath both = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, v), length, options);
    REQUIRE(both.cost <= edges.cost * (1 + 1e-14));
    REQUIRE(both.cost >= std::acos(mesh.position(0).dot(mesh.position(v))) * 0.97);  // chords of a fine sphere
    REQUIRE(path_length(both.path) == Approx(both.cost).epsilon(1e-13));
    REQUIRE(lies_on(mesh, both.path));
  }
}

TEST_CASE("ends inside faces are connected to their corners, and to each other on one face") {
  const TriangleMesh mesh(test::cube());
  EdgeGraphSearch search(mesh);
  const SurfacePoint a{0, {0.2, 0.3, 0.5}}, b{0, {0.5, 0.3, 0.2}}, c{mesh.face_count() - 1, {0.1, 0.1, 0.8}};
  const EdgePath direct = search.shortest(a, b, length);
  REQUIRE(direct.found());
  CHECK(direct.vertices.empty());
  CHECK(direct.cost == Approx((mesh.point(a) - mesh.point(b)).norm()).epsilon(1e-15));
  CHECK(direct.path.faces == std::vector<std::int32_t>{0});
  const EdgePath across = search.shortest(a, c, length, towards(mesh.point(c)));
  REQUIRE(across.found());
  CHECK(!across.vertices.empty());
  CHECK(lies_on(mesh, across.path));
  CHECK(across.path.points.front() == mesh.point(a));
  CHECK(across.path.points.back() == mesh.point(c));
  CHECK(path_length(across.path) == Approx(across.cost).epsilon(1e-14));
  const EdgePath nowhere = search.shortest(vertex_point(mesh, 3), vertex_point(mesh, 3), length);
  CHECK(nowhere.found());
  CHECK(nowhere.cost == 0);
  CHECK(nowhere.path.points.size() == 1);
}

TEST_CASE("an infinite cost is a wall") {
  const TriangleMesh mesh(test::grid(12, 12, test::Closing::kOpen, false));
  EdgeGraphSearch search(mesh);
  const double limit = mesh.position(mesh.vertex_count() / 2).x();
  const MoveCost wall = [limit](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a.x() - limit) * (b.x() - limit) <= 0 ? kInfinity : (b - a).norm();
  };
  const EdgePath path = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, mesh.vertex_count() - 1), wall);
  CHECK(path.outcome == EdgePathOutcome::no_finite_route);
  CHECK(path.failure().find("infinite") != std::string::npos);
  CHECK(path.path.points.empty());
  const EdgePath open = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, mesh.vertex_count() - 1), length);
  CHECK(open.found());  // the walls of the query before are forgotten
}

TEST_CASE("ends in different parts are told apart before any search") {
  const TriangleMesh mesh = two_parts();
  EdgeGraphSearch search(mesh);
  const EdgePath path = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 5), length);
  CHECK(path.outcome == EdgePathOutcome::different_components);
  CHECK(path.settled == 0);
  CHECK(path.source_component_size == 4);
  CHECK(path.target_component_size == 4);
  CHECK(path.failure().find("4 and 4 vertices") != std::string::npos);
}

TEST_CASE("a stop request ends the search") {
  const TriangleMesh mesh(test::sphere(5));
  EdgeGraphSearch search(mesh);
  EdgePathOptions options;
  int asked = 0;
  options.stop = [&asked] { return ++asked == 2; };
  const EdgePath path = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 1), length, options);
  CHECK(path.outcome == EdgePathOutcome::stopped);
  CHECK(path.settled < mesh.vertex_count());
  CHECK(!path.failure().empty());
}

TEST_CASE("a bound makes the search visit a fraction of a real mesh") {
  const auto file = test::data_file("meshes/duck.obj");
  if (!file) return;
  const TriangleMesh mesh(read_mesh(*file));
  EdgeGraphSearch search(mesh);
  const EdgePath dijkstra = search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 1000), length);
  const EdgePath a_star =
      search.shortest(vertex_point(mesh, 0), vertex_point(mesh, 1000), length, towards(mesh.position(1000)));
  CHECK(a_star.cost == Approx(dijkstra.cost).epsilon(1e-14));
  CHECK(a_star.settled < dijkstra.settled);
}

}  // namespace leastcost
