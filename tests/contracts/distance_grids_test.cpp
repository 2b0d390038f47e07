// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Signed-distance grids from every kind of source: the contract of a manifold.
#include "problems/geometry/build_distance_grid.hpp"
#include "problems/geometry/mesh_distance.hpp"
#include "problems/manifolds/signed_distance.hpp"
#include "tests/contracts/manifold_contract.hpp"
#include "tests/problems/sample_meshes.hpp"

namespace leastcost::test {
namespace {

std::shared_ptr<const SignedDistanceManifold> from(const DistanceSource& source, double cell) {
  SampledDistance sampled = build_distance_grid(source, {.cell = cell});
  return std::make_shared<SignedDistanceManifold>(std::move(sampled.grid));
}

std::shared_ptr<const SignedDistanceManifold> torus(double cell) {
  SignedDistanceOptions options;
  options.source = "implicit";
  options.implicit.surface = "torus";
  options.cell = cell;
  return make_signed_distance_manifold(options, {});
}

/// Points near the surface, within half a cell; nearly degenerate: 1e-8 off a face of the cells, and on a node.
ManifoldCase grid_case(const std::shared_ptr<const SignedDistanceManifold>& manifold,
                       const std::function<Eigen::Vector3d(Random&)>& on) {
  const GridShape& shape = manifold->grid().shape();
  const auto near = [on, cell = shape.cell](Random& random) -> Eigen::VectorXd {
    return on(random) + 0.2 * cell * random.vector(3);
  };
  ManifoldCase c{.manifold = manifold, .near = near, .size = (shape.upper() - shape.origin).norm()};
  Random random;
  const Eigen::Vector3d x = on(random);
  const Eigen::Vector3d node = ((x - shape.origin) / shape.cell).array().round().matrix() * shape.cell + shape.origin;
  for (const double off : {0.0, 1e-8, -1e-8}) {
    c.special.emplace_back(node + off * Eigen::Vector3d::Ones());
    c.special.emplace_back(Eigen::Vector3d(node[0] + off, x[1], x[2]));
  }
  return c;
}

}  // namespace

TEST_CASE("manifold contract: signed_distance, an implicit torus", "[contract]") {
  check_manifold_contract(grid_case(torus(0.2), [](Random& random) -> Eigen::Vector3d {
    const double u = random.uniform(0, 6.2), v = random.uniform(0, 6.2);
    return {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)};
  }));
}

TEST_CASE("manifold contract: signed_distance, a mesh", "[contract]") {
  const auto source = make_mesh_distance(TriangleMesh(sphere(3)), true);
  check_manifold_contract(
      grid_case(from(*source, 0.15), [](Random& random) -> Eigen::Vector3d { return random.vector(3).normalized(); }));
}

}  // namespace leastcost::test
