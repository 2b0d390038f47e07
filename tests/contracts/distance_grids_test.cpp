// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Signed-distance grids from every kind of source: the contract of a manifold.
#include <fstream>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include "problems/distance/mesh_distance.hpp"
#include "tests/contracts/manifold_contract.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

/// A surface to sample, in a box.
distance_source::Implicit over(const implicit::Surface& surface, const BoxOptions& box = {}) {
  return {.surface = {.surface = surface}, .box = box};
}

std::shared_ptr<const SignedDistanceManifold> from(const DistanceSource& source, double cell) {
  SampledDistance sampled = build_distance_grid(source, {.cell = cell});
  return std::make_shared<SignedDistanceManifold>(std::move(sampled.grid));
}

std::shared_ptr<const SignedDistanceManifold> torus(double cell) {
  SignedDistanceOptions options;
  options.source = over(implicit::Torus{});
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

TEST_CASE("signed distance: options that describe no grid are refused by name, before anything is read") {
  const auto key = [](const std::function<void(SignedDistanceOptions&)>& change) -> std::string {
    SignedDistanceOptions o;
    o.source = distance_source::Mesh{.file = "missing.obj"};
    change(o);
    struct Begun {};
    try {
      make_signed_distance_manifold(o, {}, [](double, std::string_view) { throw Begun(); });
    } catch (const OptionError& error) {
      return error.key();
    } catch (const Begun&) {
      return "begun";
    }
    return "accepted";
  };
  using O = SignedDistanceOptions;
  CHECK(key([](O&) {}) == "begun");
  CHECK(key([](O& o) { o.cell = o.accuracy = 1; }) == "accuracy");
  const auto mesh = [](DistanceSign sign, double offset) {
    return distance_source::Mesh{.file = "missing.obj", .sides = {sign, offset}};
  };
  CHECK(key([&](O& o) { o.source = mesh(DistanceSign::without_sides, 0); }) == "source.offset");
  CHECK(key([&](O& o) { o.source = mesh(DistanceSign::with_sides, 1); }) == "source.offset");
  CHECK(key([](O& o) { o.source = distance_source::GridFile{}, o.cell = 1; }) == "cell");
  CHECK(key([](O& o) { o.source = over(implicit::Gyroid{}); }) == "source.box");
  CHECK(key([](O& o) { o.source = over(implicit::PaperCurve{}); }) == "source.surface");
  CHECK(key([](O& o) { o.source = over(implicit::Torus{.minor_radius = 5}); }) == "source.surface.minor_radius");
  CHECK(key([](O& o) { o.source = over(implicit::Sphere{}, {.lower = Eigen::Vector3d::Zero()}); }) ==
        "source.box.lower");
  CHECK(key([](O& o) { o.source = over(implicit::Sphere{}); }) == "begun");
}

TEST_CASE("signed distance: where there is no projection, the reason is given") {
  const auto manifold = torus(0.2);
  const auto refusal = [&](const Eigen::Vector3d& x) -> std::string {
    try {
      project_end(*manifold, x);
      return "accepted";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  CHECK(refusal({2.5, 0, 0.3}) == "accepted");
  CHECK_THAT(refusal({50, 0, 0}), Catch::Contains("outside the grid, which extends from (-4.8"));
}

TEST_CASE("signed distance: read from a file, the same as made") {
  const auto made = torus(0.25);
  const GridShape& shape = made->grid().shape();
  const ScratchDir folder;
  {
    std::ofstream out(folder / "torus.sdf");
    out.precision(17);
    out << shape.count[0] << ' ' << shape.count[1] << ' ' << shape.count[2] << '\n'
        << shape.origin.transpose() << '\n'
        << shape.cell << '\n';
    for (int k = 0; k < shape.count[2]; ++k)
      for (int j = 0; j < shape.count[1]; ++j)
        for (int i = 0; i < shape.count[0]; ++i) out << made->grid().at_node(i, j, k) << '\n';
  }
  SignedDistanceOptions options;
  options.source = distance_source::GridFile{"torus.sdf"};
  const auto read = make_signed_distance_manifold(options, folder.path());
  CHECK(read->coarser());
  Eigen::Vector3d g, h;
  for (const Eigen::Vector3d& x : {Eigen::Vector3d(3, 0.1, 0), Eigen::Vector3d(0, 1.1, 0.4)}) {
    CHECK(read->grid().evaluate(x, g) == Approx(made->grid().evaluate(x, h)).margin(1e-13));
    CHECK((g - h).norm() <= 1e-12);
  }
}

}  // namespace leastcost::test
