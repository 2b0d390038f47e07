// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
//
// Rings from plane cuts on real models: around limbs, necks and handles they settle as closed geodesics, where nothing
// holds them they contract. Nothing shorter may be found beside a certified ring: neither a plane section nor the
// ring cut open.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "problems/section/plane_section.hpp"
#include "problems/straighten/straighten_ring.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"
#include "tests/support/straightened.hpp"

namespace leastcost::test {
namespace {

struct Cut {
  const char* where;
  Eigen::Vector3d point, normal;
  bool holds;  ///< false: it contracts to a point
};

struct Model {
  const char* file;
  std::vector<Cut> cuts;
};

const std::vector<Model>& models() {
  static const std::vector<Model> all = {
      {"armadillo_52k.off",
       {{"left leg", {25, -16.6, 12.7}, {0, 1, 0}, true},
        {"right leg", {-33, -16.4, 8.6}, {0, 1, 0}, true},
        {"left arm", {31.8, 54.2, 2.8}, {1, 0, 0}, true},
        {"right arm", {-31.6, 56.3, 1}, {1, 0, 0}, true},
        {"neck", {0, 70, -5}, {0, 1, 0}, true},
        {"ear", {15.8, 88.4, -23.5}, {1, 0, 0}, false},
        {"waist", {-1.6, 21.5, 12.9}, {0, 1, 0}, true},
        {"back end", {0.2, 58.8, -50}, {0, 0, 1}, false}}},
      {"camelhead.off",
       {{"neck", {0, -0.1, -0.2}, {0, 1, -0.5}, true},
        {"muzzle", {0, -0.05, 0.22}, {0, 0.3, 1}, true},
        {"ear", {0.13, 0.1, -0.3}, {0.5, 1, -0.5}, true}}},
      {"elephant.off",
       {{"handle a", {-0.177, -0.042, 0.027}, {1, 0, 0}, true},
        {"handle b", {-0.179, -0.304, -0.068}, {1, 0, 0}, true},
        {"handle c", {0.253, 0.126, 0.096}, {0, 1, 0}, true},
        {"handle d", {0.101, 0.001, 0.172}, {0, 1, 0}, true},
        {"on one side", {0, 0.065, -0.063}, {1, 0, 0}, false}}},
      {"spot.obj",
       {{"flank", {0.35, -0.19, 0.437}, {1, 0, 0}, false},
        {"neck", {0, 0.4, -0.1}, {0, 1, -1}, true},
        {"leg, which tapers", {0.293, -0.528, -0.053}, {0, 1, 0}, false}}},
  };
  return all;
}

constexpr double kTiny = 1e-12;  // relative length

/// The ring cut open at its point i and straightened as a path from that point to itself.
double cut_open_at(const TriangleMesh& mesh, const SurfacePath& ring, std::size_t i) {
  SurfacePath path = ring;
  path.points.pop_back();
  std::rotate(path.points.begin(), path.points.begin() + static_cast<std::ptrdiff_t>(i), path.points.end());
  std::rotate(path.faces.begin(), path.faces.begin() + static_cast<std::ptrdiff_t>(i), path.faces.end());
  path.points.push_back(path.points.front());
  return straighten(mesh, path).final_length;
}

/// Largest distance of a point of one curve from the nearest point of the other.
double farthest(const SurfacePath& from, const SurfacePath& to) {
  double worst = 0;
  for (const Eigen::Vector3d& p : from.points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& q : to.points) nearest = std::min(nearest, (p - q).squaredNorm());
    worst = std::max(worst, nearest);
  }
  return std::sqrt(worst);
}

void check_neighbours(const TriangleMesh& mesh, const SurfacePath& ring, const Cut& cut, double length) {
  for (std::size_t i = 0; i < ring.faces.size(); i += 1 + ring.faces.size() / 5)
    CHECK(cut_open_at(mesh, ring, i) >= length * (1 - kTiny));
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : ring.points) centre += p / static_cast<double>(ring.points.size());
  for (int i = -10; i <= 10; ++i) {
    const Eigen::Vector3d through = centre + 0.002 * i * length * cut.normal.normalized();
    for (const SurfacePath& section : section_curves(mesh, through, cut.normal).closed) {
      if (std::max(farthest(section, ring), farthest(ring, section)) < 0.1 * length)
        CHECK(path_length(section) >= length * (1 - kTiny));
    }
  }
}

void check_ring(const std::shared_ptr<const MeshManifold>& domain, const char* model, const Cut& cut, int points) {
  const Problem problem = closed(domain, make_euclidean_cost(3));
  const PlaneCutInitializer initializer({cut.point, cut.normal});
  const Result result = find_straightened(problem, points, initializer);
  std::printf("  %-18s %-16s n %4d  %-10s length %.9g of %.4g, %.3f s (solve %.3f: %s), %zu points\n", model, cut.where,
              points, word_of(result.status).data(), result.curve.cost, result.initial_cost,
              result.seconds.initialize + result.seconds.solve + result.seconds.post_process + result.seconds.certify,
              result.seconds.solve, word_of(result.solve.termination).data(),
              static_cast<std::size_t>(result.curve.x.cols()));
  CAPTURE(model, cut.where, points, failures(result.certificate));
  if (!cut.holds) {
    CHECK(result.status == Status::collapsed);
    return;
  }
  REQUIRE(result.status == Status::certified);
  CHECK(result.certificate.scope == Scope::local_on_polyhedron);
  SurfacePath ring;
  for (Index i = 0; i < result.curve.x.cols(); ++i) ring.points.emplace_back(result.curve.x.col(i));
  ring.faces = result.curve.segment_sites;
  CHECK(check_straight_ring(domain->mesh(), ring) >= -1e-9);
  check_neighbours(domain->mesh(), ring, cut, result.curve.cost);
}

}  // namespace

TEST_CASE("rings from plane cuts on real models") {
  for (const Model& model : models()) {
    const auto file = data_file("meshes/" + std::string(model.file));
    if (!file) continue;
    const auto domain = std::make_shared<const MeshManifold>(TriangleMesh(read_mesh(*file)));
    for (const Cut& cut : model.cuts)
      for (const int points : {48, 256}) check_ring(domain, model.file, cut, points);
  }
}

TEST_CASE("a plane cut that ends at the border of a real model is refused") {
  const auto file = data_file("meshes/camelhead.off");
  if (!file) return;
  const auto domain = std::make_shared<const MeshManifold>(TriangleMesh(read_mesh(*file)));
  const PlaneCutInitializer initializer({Eigen::Vector3d(0, 0.03, -0.28), Eigen::Vector3d(0, 0, 1)});
  CHECK_THROWS_WITH(initializer.first_path(closed(domain, make_euclidean_cost(3)), {}),
                    Catch::Contains("1 curve that ends at the border of the mesh"));
}

}  // namespace leastcost::test
