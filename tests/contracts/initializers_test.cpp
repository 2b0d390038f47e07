// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fstream>

#include "framework/errors.hpp"
#include "problems/initializers/dijkstra.hpp"
#include "problems/manifolds/mesh.hpp"
#include "problems/manifolds/point_cloud.hpp"
#include "problems/readers/waypoint_reader.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

constexpr double kRounding =
    1e-14;  // length units: an end goes through barycentric coordinates; all examples have size 1

/// A first path joins the ends of its problem by points of the domain, at a finite cost, the same one every time.
void check_initializer_contract(const Initializer& initializer, const Problem& problem) {
  CAPTURE(initializer.name(), problem.ring, problem.source.u.transpose(), problem.target.u.transpose());
  CHECK_FALSE(initializer.name().empty());
  const FirstPath first = initializer.first_path(problem, {});
  const CoordinatePath& path = first.path;
  REQUIRE(path.u.rows() == problem.manifold->dimensions().coordinate);
  REQUIRE(path.u.cols() >= 2);
  REQUIRE(path.u.allFinite());
  CHECK(path.ring == problem.ring);
  CHECK((path.sites.empty() || static_cast<Index>(path.sites.size()) == path.u.cols()));
  CHECK(problem.manifold->residual(path) <= kRounding);
  CHECK(PathEnergy(problem, 1).costs(path).allFinite());
  if (!problem.ring) {
    CHECK((path.u.col(0) - problem.source.u).norm() <= kRounding);
    CHECK((path.u.rightCols(1) - problem.target.u).norm() <= kRounding);
  }
  CHECK(initializer.first_path(problem, {}).path.u == path.u);
}

std::shared_ptr<const MeshManifold> ball() {
  static const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(3)));
  return mesh;
}

/// Typical, nearly degenerate (ends 1e-8 apart, an end on or 1e-8 off a sample) and random ends on a sampled sphere.
std::vector<Problem> problems_on_cloud() {
  static const auto cloud = std::make_shared<const PointCloudManifold>(PointCloud(sphere_cloud(2000), {}));
  Random random;
  const Eigen::Vector3d a(0.1, 0.2, 0.97), b(0.9, -0.3, -0.3), off(1e-8, 2e-8, 0);
  const Eigen::Vector3d sample = cloud->cloud().sample(5).position + cloud->cloud().centre();
  const Eigen::Vector3d c = random.vector(3).normalized(), d = random.vector(3).normalized();
  std::vector<Problem> all;
  for (const auto& [from, to] : std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>{
           {a, b}, {a, a + off}, {sample, b}, {a, sample}, {sample + off, b}, {c, d}})
    all.push_back(between(cloud, make_euclidean_cost(3), from, to));
  return all;
}

/// Typical, nearly degenerate (ends 1e-8 apart, an end on or 1e-8 off a vertex) and random ends on the ball.
std::vector<Problem> problems_on_mesh() {
  Random random;
  const Eigen::Vector3d a(0.1, 0.2, 0.97), b(0.9, -0.3, -0.3), v = ball()->mesh().position(5);
  const Eigen::Vector3d off(1e-8, 2e-8, 0);
  std::vector<Problem> all;
  for (const auto& [from, to] : std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>{
           {a, b}, {a, a + off}, {v, b}, {a, v}, {v + off, b}, {random.vector(3), random.vector(3)}})
    all.push_back(between(ball(), make_euclidean_cost(3), from, to));
  return all;
}

/// The same in the plane, with a bead whose straight line is infinitely slow.
std::vector<Problem> problems_in_plane() {
  Random random;
  const Eigen::Vector2d zero(0, 0), off(1e-8, 0), side(1, 0);
  return {between(space(2), make_euclidean_cost(2), zero, side), between(space(2), make_euclidean_cost(2), zero, off),
          between(space(2), make_euclidean_cost(2), random.vector(2), random.vector(2)), bead(zero, side),
          bead(zero, Eigen::Vector2d(1, -1e-8))};
}

Points triangle_around_z() {
  Points points(3, 3);
  points << 1, -0.5, -0.5, 0, 0.8, -0.8, 0.1, 0.1, 0.1;
  return points;
}

}  // namespace

TEST_CASE("initializer contract: straight", "[contract]") {
  for (const Problem& problem : problems_in_plane()) check_initializer_contract(StraightInitializer(), problem);
  check_initializer_contract(StraightInitializer(), problems_on_mesh().front());
  CHECK_THROWS_AS(StraightInitializer().first_path(closed(space(2), make_euclidean_cost(2)), {}), InitializationError);
}

TEST_CASE("initializer contract: dijkstra", "[contract]") {
  for (const Problem& problem : problems_on_mesh()) check_initializer_contract(DijkstraInitializer(), problem);
  for (const Problem& problem : problems_on_cloud()) check_initializer_contract(DijkstraInitializer(), problem);
  CHECK_THROWS_AS(DijkstraInitializer({2}).first_path(problems_on_cloud().front(), {}), InputError);
  CHECK_THROWS_AS(DijkstraInitializer().first_path(problems_in_plane().front(), {}), InputError);
  CHECK_THROWS_AS(DijkstraInitializer().first_path(closed(ball(), make_euclidean_cost(3)), {}), InitializationError);
}

TEST_CASE("initializer contract: waypoints", "[contract]") {
  const WaypointsInitializer below(Eigen::Vector2d(0.3, -0.5)), around(triangle_around_z());
  for (const Problem& problem : problems_in_plane()) check_initializer_contract(below, problem);
  for (const Problem& problem : problems_on_mesh()) check_initializer_contract(around, problem);
  check_initializer_contract(around, closed(space(3), make_euclidean_cost(3)));
  check_initializer_contract(around, closed(ball(), make_euclidean_cost(3)));
  CHECK_THROWS_AS(WaypointsInitializer(Points(2, 0)), OptionError);
}

TEST_CASE("initializer contract: file", "[contract]") {
  const ScratchDir folder;
  std::ofstream(folder / "tour.csv") << "x,y,z\n1,0,0.1\n-0.5,0.8,0.1\n-0.5,-0.8,0.1\n";
  const WaypointsInitializer around(read_waypoints(folder / "tour.csv", 3));
  for (const Problem& problem : problems_on_mesh()) check_initializer_contract(around, problem);
  check_initializer_contract(around, closed(ball(), make_euclidean_cost(3)));
}

}  // namespace leastcost::test
