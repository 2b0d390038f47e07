// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include <leastcost/problems/manifolds/earth.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/contracts/manifold_contract.hpp"
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/problems/sample_rasters.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

/// Points in faces of a mesh (barycentric coordinates above 0.1), lifted off it by less than a tenth of an edge.
ManifoldCase mesh_case(const PolygonSoup& soup) {
  const auto manifold = std::make_shared<MeshManifold>(TriangleMesh(soup));
  const TriangleMesh& mesh = manifold->mesh();
  const auto near = [&mesh](Random& random) -> Eigen::VectorXd {
    const std::int32_t f = random.integer(0, mesh.face_count() - 1);
    Eigen::Vector3d b(random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
    b /= b.sum();
    return mesh.point({f, b}) + random.uniform(-0.01, 0.01) * mesh.face_normal(f);
  };
  ManifoldCase c{.manifold = manifold, .near = near, .size = mesh.diameter(), .step = 0.02 * mesh.diameter()};
  const auto& [p, q, r] = mesh.face(0);
  const Eigen::Vector3d a = mesh.position(p), edge = (a + mesh.position(q)) / 2;
  for (const double off : {0.0, 1e-8}) {
    for (const Eigen::Vector3d& x : {a, edge}) {
      c.special.push_back(x + off * mesh.face_normal(0));
      c.special.push_back(x + off * (mesh.position(r) - x));
      c.special.push_back(x - off * (mesh.position(r) - x));
    }
  }
  return c;
}

ManifoldCase box_case(int d) {
  ManifoldCase c{.manifold = box(-Eigen::VectorXd::Ones(d), Eigen::VectorXd::Constant(d, 2)),
                 .near = [d](Random& random) -> Eigen::VectorXd { return 2 * random.vector(d); },
                 .size = 3};
  const Eigen::VectorXd corner = Eigen::VectorXd::Constant(d, 2), side = 2 * Eigen::VectorXd::Unit(d, 0);
  for (const double off : {0.0, 1e-8, -1e-8})
    for (const Eigen::VectorXd& x : {corner, side}) c.special.emplace_back(x + off * Eigen::VectorXd::Ones(d));
  return c;
}

/// Points on the torus with radii 20 and 10, lifted off it by less than a tenth of a support; nearly degenerate: on a
/// sample and beside it.
ManifoldCase cloud_case() {
  const auto manifold = std::make_shared<PointCloudManifold>(PointCloud(torus_cloud(3000, 10), {}));
  const auto near = [](Random& random) -> Eigen::VectorXd {
    const double u = random.uniform(0, 6.2), v = random.uniform(0, 6.2), r = 10 + random.uniform(-0.3, 0.3);
    return Eigen::Vector3d((20 + r * std::cos(v)) * std::cos(u), (20 + r * std::cos(v)) * std::sin(u), r * std::sin(v));
  };
  ManifoldCase c{.manifold = manifold, .near = near, .size = manifold->cloud().diameter()};
  const CloudSample& sample = manifold->cloud().sample(7);
  const Eigen::Vector3d p = sample.position + manifold->cloud().centre();
  for (const double off : {0.0, 1e-8, -1e-8}) {
    c.special.emplace_back(p + off * sample.normal);
    c.special.emplace_back(p + off * sample.normal.unitOrthogonal());
  }
  return c;
}

}  // namespace

TEST_CASE("manifold contract: euclidean, free", "[contract]") {
  const int d = GENERATE(1, 2, 3, 7);
  check_manifold_contract({.manifold = space(d), .near = [d](Random& random) { return random.vector(d); }});
}
TEST_CASE("manifold contract: euclidean, box", "[contract]") {
  check_manifold_contract(box_case(GENERATE(1, 2, 3, 7)));
}
TEST_CASE("manifold contract: mesh, cube", "[contract]") { check_manifold_contract(mesh_case(cube())); }
TEST_CASE("manifold contract: mesh, sphere", "[contract]") { check_manifold_contract(mesh_case(sphere(3))); }
TEST_CASE("manifold contract: mesh with a border", "[contract]") {
  check_manifold_contract(mesh_case(grid(6, 3, Closing::kRound, false)));
}

TEST_CASE("manifold contract: map", "[contract]") {
  OccupancyGrid cells;
  cells.rows = 4;
  cells.columns = 5;
  cells.blocked.assign(20, false);
  for (const auto& [row, column] : {std::pair{1, 1}, {1, 2}, {2, 3}, {0, 4}})
    cells.blocked[cells.index(row, column)] = true;
  cells.cell = 0.25;
  cells.origin = Eigen::Vector2d(-0.5, -0.5);
  check_manifold_contract({.manifold = std::make_shared<const MapManifold>(cells),
                           .near = [](Random& random) { return Eigen::VectorXd(0.6 * random.vector(2)); },
                           .special = {Eigen::Vector2d(-0.25, -0.25 - 1e-8), Eigen::Vector2d(0.25 + 1e-8, 0)}});
}

/// Every seam against the embedding. (Poles and derivatives are part of the contract.)
void check_seams(const ParametricManifold& manifold, const Points& points) {
  const CoordinatePath path{points, {}, true};
  Points x, embedded;
  manifold.embed(path, x);
  for (std::size_t s = 0; s < manifold.seams().size(); ++s) {
    const SeamMap map = seam_map(
        manifold.seams(), 2, Eigen::VectorXi::Unit(static_cast<Index>(manifold.seams().size()), static_cast<Index>(s)));
    for (Index i = 0; i < points.cols(); ++i) {
      const CoordinatePath image{map.apply(points.col(i)), {}, true};
      manifold.embed(image, embedded);
      CHECK((embedded - x.col(i)).norm() <= 1e-13 * x.cwiseAbs().maxCoeff());
      CHECK((map.undo(image.u) - points.col(i)).norm() <= 1e-13 * x.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("manifold contract: parametric", "[contract]") {
  ParametricOptions options;
  options.surface = form<parametric::Surface>(GENERATE("plane", "sphere", "ellipsoid", "torus", "cylinder", "cone",
                                                       "catenoid", "paraboloid", "hyperboloid", "klein_bottle",
                                                       "moebius_strip", "spiral", "enneper", "formula"));
  CAPTURE(type_of(options.surface));
  if (auto* formula = std::get_if<parametric::Formula>(&options.surface))
    *formula = {.x = "u * cos(v)", .y = "u * sin(v)", .z = "exp(-u^2)"};
  options.box.lower = Eigen::Vector2d(-2, -1.5);
  options.box.upper = Eigen::Vector2d(2, 1.5);
  const auto manifold = make_parametric_manifold(options);
  ManifoldCase c{
      .manifold = manifold,
      .near = [](Random& random) -> Eigen::VectorXd { return Eigen::Vector2d(0.2, 0.6) + 0.9 * random.vector(2); },
      .size = 4};
  for (const double off : {0.0, 1e-8, -1e-8}) c.special.emplace_back(Eigen::Vector2d(2 + off, 0.1));
  check_manifold_contract(c);
  Random random;
  Points points(2, 6);
  for (Index i = 0; i < points.cols(); ++i) points.col(i) = c.near(random);
  check_seams(*manifold, points);
}

TEST_CASE("manifold contract: earth", "[contract]") {
  const auto manifold = std::make_shared<const EarthManifold>();
  const auto near = [](Random& random) -> Eigen::VectorXd {
    return Eigen::Vector2d(random.uniform(-85, 85), random.uniform(-200, 200));
  };
  check_manifold_contract({.manifold = manifold, .near = near, .size = 6.4e6, .step = 1});
  Random random;
  Points points(2, 6);
  for (Index i = 0; i < points.cols(); ++i) points.col(i) = near(random);
  check_seams(*manifold, points);
}

TEST_CASE("manifold contract: terrain", "[contract]") {
  const auto manifold = std::make_shared<const TerrainManifold>(raster_of(20, 20, waves));
  ManifoldCase c{.manifold = manifold,
                 .near = [](Random& random) -> Eigen::VectorXd {
                   return Eigen::Vector2d(random.uniform(-0.5, 8.5), random.uniform(2.2, 6.8));
                 },
                 .size = 10};
  const Eigen::Vector2d corner = manifold->box_upper();
  for (const double off : {0.0, 1e-8, -1e-8}) c.special.emplace_back(corner + off * Eigen::Vector2d(1, -1));
  check_manifold_contract(c);
}

TEST_CASE("manifold contract: point_cloud, a sampled torus", "[contract]") { check_manifold_contract(cloud_case()); }

TEST_CASE("formulas that are no surface, or do not have their period, are refused", "[contract]") {
  parametric::Formula formula{.x = "cos(u)", .y = "sin(u)", .z = "v"};
  const auto key = [&]() -> std::string {
    try {
      make_parametric_manifold({.surface = formula});
    } catch (const OptionError& error) {
      return error.key();
    }
    return "accepted";
  };
  formula.period_u = 2 * std::acos(-1.0);
  CHECK(key() == "accepted");
  formula.twisted = true;
  CHECK(key() == "surface.period_u");
  formula.twisted = false;
  formula.period_u = 3;
  CHECK(key() == "surface.period_u");
  formula.period_u = -3;
  CHECK(key() == "surface.period_u");
  formula.period_u.reset();
  formula.z = "sin(u)";
  CHECK(key() == "surface");
  formula.x = formula.y = formula.z = "u - v";
  CHECK(key() == "surface");
  formula.y = "u + v";
  CHECK(key() == "accepted");
}

// The helpers of the tests must keep the contract as well, or what is tested with them means nothing.
TEST_CASE("manifold contract: the sphere and the torus of the tests", "[contract]") {
  const auto near = [](Random& random) -> Eigen::VectorXd {
    return 3 * random.vector(3).normalized() + 0.3 * random.vector(3);
  };
  check_manifold_contract({.manifold = std::make_shared<Sphere>(), .near = near});
  check_manifold_contract({.manifold = std::make_shared<Torus>(), .near = near, .size = 3});
}

TEST_CASE("a box that is none is refused by name", "[contract]") {
  const auto key = [](int dimension, const std::optional<Eigen::VectorXd>& lower,
                      const std::optional<Eigen::VectorXd>& upper) -> std::string {
    try {
      EuclideanManifold({dimension, {lower, upper}});
    } catch (const OptionError& error) {
      return error.key();
    }
    return "accepted";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(key(0, {}, {}) == "dimension");
  CHECK(key(1000, {}, {}) == "dimension");
  CHECK(key(2, Eigen::Vector3d::Zero(), {}) == "lower");
  CHECK(key(2, {}, Eigen::Vector2d(nan, 1)) == "upper");
  CHECK(key(2, Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0)) == "lower");
  CHECK(key(2, {}, Eigen::Vector2d(1, 0)) == "accepted");
}

}  // namespace leastcost::test
