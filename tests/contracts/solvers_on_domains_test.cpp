// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Every registered solver, with every algorithm it offers, on every kind of domain: it comes to the cost that newton
// comes to, or says before it starts why it cannot.
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/manifolds/product.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include "app/reference/field_list.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/registry/registry.hpp"
#include "tests/app/config_text.hpp"
#include "tests/contracts/solver_contract.hpp"
#include "tests/problems/sample_clouds.hpp"

namespace leastcost::test {
namespace {

constexpr int kFewPoints = 6;
constexpr double kSameCost = 1e-4;    ///< relative; methods with a rule of their own space the points differently
constexpr double kSameKinked = 1e-3;  ///< where the cost has kinks: each method may rest in one of its own

struct NamedSolver {
  std::string name;
  std::shared_ptr<const Solver> solver;
};

NamedSolver configured(const std::string& block) {
  const LoadedConfig loaded = parse(kPlane + "solver: " + block + "\n");
  CAPTURE(block, loaded.errors.render());
  REQUIRE(loaded.errors.empty());
  return {block, make<std::shared_ptr<const Solver>>(loaded.config.solver, {})};
}

/// Those that look for a better path, as their defaults make them, one per choice of `algorithm`.
std::vector<NamedSolver> all_solvers() {
  std::vector<NamedSolver> all;
  for (const PluginEntry* plugin : kind("solver").entries) {
    if (!plugin->missing.empty()) continue;
    std::vector<std::string> algorithms;
    std::string limit;
    for (const app::FieldInfo& field : app::fields_of(*plugin->defaults())) {
      if (field.key == "algorithm") algorithms = field.choices;
      if (field.key == "max_evaluations") limit = ", max_evaluations: 3000";
    }
    if (algorithms.empty()) all.push_back(configured("{type: " + plugin->type + limit + "}"));
    for (const std::string& algorithm : algorithms)
      all.push_back(configured("{type: " + plugin->type + ", algorithm: " + algorithm + limit + "}"));
  }
  std::erase_if(all, [](const NamedSolver& s) { return !s.solver->moves_points(); });
  return all;
}

StandardProblem few(const char* name, const Problem& problem, const Initializer& initializer) {
  const bool kinked = problem.manifold->shape() == Shape::polyhedral || find_ability<HasWalls>(*problem.manifold);
  return {name, problem, sample_equally(problem, initializer.first_path(problem, {}).path, kFewPoints),
          kinked ? kSameKinked : kSameCost};
}

std::shared_ptr<const ConstraintManifold> torus_grid() {
  SignedDistanceOptions options;
  options.source = distance_source::Implicit{.surface = {.surface = implicit::Torus{}}, .box = {}};
  options.cell = 0.25;
  return make_signed_distance_manifold(options, {});
}

/// One problem per kind of domain. The bow of the first path is to be pulled tight.
std::vector<StandardProblem> domains() {
  using Eigen::Vector2d;
  using Eigen::Vector3d;
  const auto hyperbolic = make_segment_cost(HyperbolicPlane{});
  const auto length = make_euclidean_cost(3);
  const Vector3d from = Torus::at(0, 0), to = Torus::at(1, 2), over = Torus::at(0.8, 0.8);
  const WaypointsInitializer bowed(over);
  ParametricOptions chart;
  chart.surface = parametric::Torus{};
  const auto disc = make_ball({.center = Vector2d(1.5, 0.1), .radius = 0.5});
  const auto mesh = std::make_shared<MeshManifold>(TriangleMesh(sphere(2)));
  const auto product =
      std::make_shared<ProductManifold>(ProductManifold::Factors{std::make_shared<Sphere>(), space(1)});
  const Eigen::Vector4d low(1, 0, 0, 0), high(0, 1, 0, 1);
  return {
      few("plane", between(space(2), hyperbolic, Vector2d(0, 1), Vector2d(2, 3)), StraightInitializer()),
      few("chart", between(make_parametric_manifold(chart), length, Vector2d(0, 0.2), Vector2d(1, 2)),
          StraightInitializer()),
      few("level set", between(make_implicit_manifold({.surface = implicit::Torus{}}), length, from, to), bowed),
      few("distance grid", between(torus_grid(), length, from, to), bowed),
      few("mesh", between(mesh, length, Vector3d(1, 0, 0.2).normalized(), Vector3d(-0.5, 1, 0.4).normalized()),
          DijkstraInitializer()),
      few("cloud", between(std::make_shared<PointCloudManifold>(PointCloud(torus_cloud(1500), {})), length, from, to),
          bowed),
      few("product", between(product, make_euclidean_cost(4), low, high),
          WaypointsInitializer(Eigen::Vector4d(0.6, 0.6, 0.52, 0.1))),
      few("obstacles",
          between(std::make_shared<FreeSpace>(space(2), FreeSpace::Obstacles{disc}, 0.0), make_euclidean_cost(2),
                  Vector2d(0, 0), Vector2d(3, 0)),
          WaypointsInitializer(Vector2d(1.5, -1))),
  };
}

}  // namespace

TEST_CASE("every solver on every kind of domain: the same cost, or why not before it starts", "[contract]") {
  const std::vector<NamedSolver> solvers = all_solvers();
  for (const StandardProblem& p : domains()) {
    CoordinatePath best = p.start;
    PathEnergy fine = energy_at_mean(p);
    Newton().solve(fine, best, {});
    const double least = fine.cost(best);
    CHECK(fine.cost(p.start) > 1.02 * least);  // there is something to gain
    std::size_t solved = 0;
    for (const NamedSolver& s : solvers) {
      CAPTURE(p.name, s.name);
      PathEnergy energy = energy_at_mean(p);
      CoordinatePath path = p.start;
      const auto reason = s.solver->cannot_solve(energy, path);
      const SolveReport report = s.solver->solve(energy, path, {});
      CAPTURE(word_of(report.termination), report.message, report.iterations, energy.cost(path) / least - 1);
      CHECK((report.termination == Termination::refused) == reason.has_value());
      if (reason)
        CHECK(path.u == p.start.u);
      else
        CHECK(std::abs(energy.cost(path) / least - 1) <= p.tolerance);
      if (!reason) ++solved;
    }
    CHECK(solved + 1 >= solvers.size());  // georce needs a chart
  }
}

}  // namespace leastcost::test
