// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// One surface, several representations: the same cost, kernel, solver and certificate, and what each of them costs.
// Prints the table of the README.
#include <cstdio>
#include <string>

#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/sample_domains.hpp"
#include "tests/support/straightened.hpp"
#include "tests/support/trials.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kPoints = 127;

/// A surface with a geodesic of known length (docs/oracles.md D1).
struct Surface {
  const char* name;
  Vector2d source, target;  ///< in the chart
  double length;
  Vector3d (*at)(double u, double v);
  PointSamples (*cloud)(int count);
  PolygonSoup (*mesh)(int level);  ///< half the edge length at each level
};

Vector3d on_sphere(double u, double v) { return {std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)}; }

/// A torus mesh of radii 3 and 1, drawn in to 2 and 1.
PolygonSoup torus_mesh(int level) {
  PolygonSoup soup = grid(12 << level, 7 << level, Closing::kRound, true);
  for (Vector3d& p : soup.positions) p.head<2>() *= 1 - 1 / p.head<2>().norm();
  return soup;
}

const Surface kSphere{"sphere",
                      Vector2d(20, 10) * kDegree,
                      Vector2d(130, 50) * kDegree,
                      1.6543777367571768,
                      on_sphere,
                      [](int count) { return sphere_cloud(count); },
                      [](int level) { return sphere(level + 2); }};
const Surface kTorus{
    "torus", {0, 0}, {1, 2}, 3.00530920550149849, Torus::at, [](int count) { return torus_cloud(count); }, torus_mesh};

void print(const Surface& surface, const std::string& representation, const Result& result) {
  const CostEstimate& e = result.certificate.estimate;
  char domain[16] = "";
  if (const auto& error = result.certificate.geometry_error) std::snprintf(domain, sizeof domain, "%.1e", *error);
  std::printf("| %-6s | %-23s | %-11s | %.11f | %.1e | %7s | %8.1e |\n", surface.name, representation.c_str(),
              word_of(result.status).data(), e.value, e.error, domain, e.value - surface.length);
}

/// Certified, and the closed form within the error bar and what the representation itself costs.
void covers(const Surface& surface, const std::string& representation, const Result& result) {
  const Certificate& c = result.certificate;
  print(surface, representation, result);
  CAPTURE(surface.name, representation, c.estimate.value, c.estimate.error, failures(c));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(c.estimate.value - surface.length) <=
        c.estimate.error + c.geometry_error.value_or(0) + 1e-14 * surface.length);
}

Problem between_ends(const Surface& s, std::shared_ptr<const ConstraintManifold> manifold) {
  return between(std::move(manifold), make_euclidean_cost(3), s.at(s.source[0], s.source[1]),
                 s.at(s.target[0], s.target[1]));
}

}  // namespace

TEST_CASE("one surface, five representations", "[oracle]") {
  const Surface& s = *GENERATE(from_range(share<const Surface*>({&kTorus, &kSphere}, 2)));

  const ParametricOptions chart{.surface = form<parametric::Surface>(s.name)};
  covers(s, "parametric",
         find(between(make_parametric_manifold(chart), make_euclidean_cost(3), s.source, s.target), kPoints));
  const ImplicitManifoldOptions implicit{.surface = form<implicit::Surface>(s.name)};
  covers(s, "implicit", find(between_ends(s, make_implicit_manifold(implicit)), kPoints));
  for (const char* cell : {"0.2", "0.1"}) {
    SignedDistanceOptions grid;
    grid.source = distance_source::Implicit{.surface = implicit};
    grid.cell = std::stod(cell);
    covers(s, std::string("distance grid, cell ") + cell,
           find(between_ends(s, make_signed_distance_manifold(grid, "")), kPoints));
  }
  for (const int count : share<int>({5000, 20000}, 2))
    covers(s, "cloud, " + std::to_string(count) + " points",
           find(between_ends(s, std::make_shared<const PointCloudManifold>(PointCloud(s.cloud(count), {}))), kPoints,
                DijkstraInitializer()));

  double previous = 0;
  for (const int level : {2, 3, 4}) {
    const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(s.mesh(level)));
    const Result result =
        find_straightened(between_ends(s, mesh), kPoints, DijkstraInitializer({.routes = 2}), Newton());
    const Certificate& c = result.certificate;
    print(s, "mesh, " + std::to_string(mesh->mesh().face_count()) + " faces", result);
    CAPTURE(s.name, level, failures(c));
    CHECK(result.status == Status::certified);
    CHECK(c.scope == Scope::local_on_polyhedron);
    const double off = std::abs(c.estimate.value - s.length);
    if (previous > 0) {
      CHECK(previous / off > 2.5);  // second order: 4, less what the place of the path between the vertices changes
      CHECK(previous / off < 6);
    }
    previous = off;
  }
}

}  // namespace leastcost::test
