// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

Problem cycloid(double x = std::numbers::pi) { return bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(x, -2)); }
Problem on_sphere() {
  return between(std::make_shared<Sphere>(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0),
                 Eigen::Vector3d(0, 0.6, 0.8));
}

/// Leaves every path as it is.
class Idle final : public Solver {
 public:
  std::string_view name() const override { return "idle"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor&) const override {
    SolveReport report;
    report.termination = Termination::fixed_point;
    report.final_energy = energy.value(path);
    return report;
  }
};

FindOptions at(double reference_cost) {
  FindOptions options;
  options.reference_cost = reference_cost;
  return options;
}

}  // namespace

TEST_CASE("improve_path: from its own result it converges at once to the same path", "[framework]") {
  const Problem problem = GENERATE(cycloid(), on_sphere());
  const Result before = find(problem, 40, StraightInitializer());
  REQUIRE(before.status == Status::certified);
  const Result after = improve_path(problem, before.path, Newton(), at(before.reference_cost));
  CHECK(after.status == Status::certified);
  CHECK(after.solve.iterations <= 2);
  CHECK(after.initial.u == before.path.u);
  CHECK((after.path.u - before.path.u).cwiseAbs().maxCoeff() <= 1e-12);
  CHECK(after.certificate.estimate.value == Approx(before.certificate.estimate.value).epsilon(1e-12));
}

TEST_CASE("improve_path: takes the points as they are, however unevenly spaced", "[framework]") {
  const Problem problem = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 2));
  CoordinatePath chain{Points(2, 5), {}, false};
  chain.u << 0, 0.1, 0.15, 0.9, 1, 0, 1, 0.2, 1.1, 2;
  FindOptions options;
  options.certificate.enabled = false;
  const Result result = improve_path(problem, chain, Idle(), options);
  CHECK(result.initial.u == chain.u);
  CHECK(result.path.u == chain.u);
}

TEST_CASE("improve_path: replanning to an end that has moved", "[framework]") {
  const Result before = find(cycloid(), 40);
  const Problem moved = cycloid(std::numbers::pi + 0.05);
  const Result after = improve_path(moved, before.path, Newton());
  const Result fresh = find(moved, 40);
  CHECK(after.status == Status::certified);
  CHECK(after.path.u.rightCols(1) == moved.target.u);
  CHECK(after.solve.iterations < fresh.solve.iterations);
  CHECK(after.certificate.estimate.value == Approx(fresh.certificate.estimate.value).epsilon(1e-9));
}

TEST_CASE("improve_path: on a mesh sites are found where they are missing", "[framework]") {
  const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(3)));
  const Problem problem =
      between(mesh, make_euclidean_cost(3), Eigen::Vector3d(0.1, 0.2, 0.97), Eigen::Vector3d(0.9, -0.3, -0.3));
  FindOptions options;
  options.points = 20;
  options.certificate.enabled = false;
  const Result before = find_path(problem, StraightInitializer(), Lbfgs(), options);
  CoordinatePath chain = before.path;
  chain.sites.clear();
  Problem bare = problem;
  bare.source.site = bare.target.site = kNoSite;
  const Result after = improve_path(bare, chain, Lbfgs(), options);
  CHECK(after.path.sites.size() == static_cast<std::size_t>(after.path.u.cols()));
  CHECK(after.costs.sum() <= before.costs.sum() * (1 + 1e-9));
  CHECK(mesh->residual(after.path) < 1e-12);
}

TEST_CASE("improve_path: what is no chain of the problem is refused", "[framework]") {
  const Problem problem = cycloid();
  const CoordinatePath good = find(problem, 8).path;
  const auto refuses = [&](auto change, const char* why) {
    CoordinatePath chain = good;
    change(chain);
    CHECK_THROWS_AS(improve_path(problem, chain, Newton()), InputError);
    CHECK_THROWS_WITH(improve_path(problem, chain, Newton()), Catch::Contains(why));
  };
  refuses([](CoordinatePath& c) { c.u.resize(2, 0); }, "2 x 0");
  refuses([](CoordinatePath& c) { c.u.conservativeResize(2, 2); }, "at least 3");
  refuses(
      [](CoordinatePath& c) {
        c.u.conservativeResize(3, 10);
        c.u.row(2).setZero();
      },
      "2 rows");
  refuses([](CoordinatePath& c) { c.u(1, 3) = std::nan(""); }, "not finite");
  refuses([](CoordinatePath& c) { c.ring = true; }, "ring");
  refuses([](CoordinatePath& c) { c.sites = {0, 0}; }, "2 sites");
  CoordinatePath above = good;
  above.u(1, 4) = 3;
  CHECK_THROWS_AS(improve_path(problem, above, Newton()), InitializationError);
  CHECK_THROWS_WITH(improve_path(problem, above, Newton()), Catch::Contains("infinite"));
  const Problem curved = on_sphere();
  CoordinatePath centre = find(curved, 8).path;
  centre.u.col(4).setZero();
  CHECK_THROWS_WITH(improve_path(curved, centre, Newton()), Catch::Contains("column 4"));
}

}  // namespace leastcost::test
