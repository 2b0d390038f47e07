// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Geodesics of the sphere and the torus on grids made from their equation, from a mesh and from a cloud.
#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include "problems/distance/cloud_distance.hpp"
#include "problems/distance/implicit_distance.hpp"
#include "problems/distance/mesh_distance.hpp"
#include "problems/level_set/named_surfaces.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const SignedDistanceManifold> grid_of(const std::shared_ptr<const DistanceSource>& source,
                                                      double cell) {
  return std::make_shared<SignedDistanceManifold>(build_distance_grid(*source, {.cell = cell}), source);
}
std::shared_ptr<const DistanceSource> implicit_sphere() {
  return make_implicit_distance(make_sphere_function(3, 1), {Vector3d::Constant(-1), Vector3d::Constant(1)});
}
std::shared_ptr<const DistanceSource> implicit_torus() {
  return make_implicit_distance(make_torus_function(2, 1), {Vector3d(-3, -3, -1), Vector3d(3, 3, 1)});
}

/// Points of docs/oracles.md D1 torus-a, whose geodesic has the length 3.00530920550149849.
constexpr double kTorusLength = 3.00530920550149849;
Result torus_a(const std::shared_ptr<const SignedDistanceManifold>& torus) {
  const auto at = [](double u, double v) {
    return Vector3d((2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v));
  };
  return find(between(torus, make_euclidean_cost(3), at(0, 0), at(1, 2)), 127,
              WaypointsInitializer(Vector3d(2.2, 1.2, 0.85)));
}

double covered_error(const Certificate& c) { return c.estimate.error + c.geometry_error.value(); }

}  // namespace

TEST_CASE("distance grid oracle: torus-a from the equation, order 4") {
  double last = 0;
  for (const double cell : {0.2, 0.1}) {
    const Result result = torus_a(grid_of(implicit_torus(), cell));
    const Certificate& c = result.certificate;
    CAPTURE(cell, failures(c));
    CHECK(c.certified());
    const double error = std::abs(c.estimate.value - kTorusLength);
    CHECK(error <= covered_error(c));
    if (last > 0) CHECK(error <= last / 7);  // one path may be lucky at the first cell: 16 on average
    last = error;
  }
  CHECK(last <= 1e-6);
}

TEST_CASE("distance grid oracle: random arcs of the sphere, order 4 and covered") {
  double last = 0;
  for (const double cell : {0.2, 0.1}) {
    const auto ball = grid_of(implicit_sphere(), cell);
    Random random;
    double worst = 0;
    for (int i = 0; i < 12; ++i) {
      const Vector3d a = random.vector(3).normalized();
      const Vector3d b = (a + 0.8 * random.vector(3).normalized()).normalized();
      const Problem problem = between(ball, make_euclidean_cost(3), a, b);
      const Result result = find(problem, 31);
      CHECK(result.certificate.certified());
      const Vector3d p = problem.source.u, q = problem.target.u;
      const double error = std::abs(result.certificate.estimate.value - std::atan2(p.cross(q).norm(), p.dot(q)));
      CHECK(error <= covered_error(result.certificate));
      worst = std::max(worst, error);
    }
    if (last > 0) CHECK(std::log2(last / worst) > 3);
    last = worst;
  }
}

TEST_CASE("distance grid oracle: torus-a from 6000 samples") {
  const auto torus = grid_of(make_cloud_distance(PointCloud(torus_cloud(6000), {}), true), 0.25);
  const Certificate c = torus_a(torus).certificate;
  CAPTURE(failures(c));
  CHECK(c.certified());
  CHECK(std::abs(c.estimate.value - kTorusLength) <= covered_error(c));
  CHECK(covered_error(c) <= 0.02);
}

// The domain of a grid made from a mesh is that mesh, whose geodesic between the same points is found by straightening;
// edges of 0.1 against cells above and below that.
TEST_CASE("distance grid oracle: random paths on a polyhedron") {
  const TriangleMesh mesh{sphere(4)};
  const auto polyhedron = std::make_shared<MeshManifold>(mesh);
  const auto source = make_mesh_distance(mesh, true);
  for (const double cell : {0.2, 0.1, 0.05}) {
    const auto domain = grid_of(source, cell);
    Random random;
    for (int i = 0; i < 6; ++i) {
      const Vector3d a = random.vector(3).normalized();
      const Vector3d b = (a + 0.8 * random.vector(3).normalized()).normalized();
      const Problem problem = between(domain, make_euclidean_cost(3), a, b);
      const Certificate c = find(problem, 255).certificate;
      CAPTURE(cell, failures(c));
      CHECK(c.certified());
      FindOptions options;
      options.points = 31;
      options.post_processors = {std::make_shared<const StraightenPostProcessor>()};
      const Problem exact = between(polyhedron, make_euclidean_cost(3), problem.source.u, problem.target.u);
      const Result truth = find_path(exact, DijkstraInitializer(DijkstraOptions{}), Lbfgs(), options);
      CHECK(std::abs(c.estimate.value - truth.certificate.estimate.value) <= covered_error(c));
    }
  }
}

}  // namespace leastcost::test
