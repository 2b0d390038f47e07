// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// By how much thread time find_path() overruns its deadline: n x domain x solver, the 99th of 100 deadlines. Allowed:
// max(1 ms, a tenth of the budget); 5 ms for NLopt and Ceres.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/problems/sample_clouds.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/overrun.hpp"
#include "tests/support/sample_domains.hpp"
#ifdef LEASTCOST_HAS_NLOPT
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>
#endif
#ifdef LEASTCOST_HAS_CERES
#include <leastcost/solvers/ceres/ceres_solver.hpp>
#endif

namespace {

using namespace leastcost;

struct Row {
  std::string name;
  Problem problem;
  std::shared_ptr<const Initializer> initializer;
  FindOptions options;
};

struct Column {
  std::shared_ptr<const Solver> solver;
  double allowed;  ///< seconds, at least
};

/// Ends in the coordinates of the domain.
Problem between(std::shared_ptr<const ConstraintManifold> manifold,
                const Eigen::VectorXd& source = Eigen::Vector3d(0.1, 0.2, 0.97),
                const Eigen::VectorXd& target = Eigen::Vector3d(0.9, -0.3, -0.3)) {
  Problem problem;
  problem.manifold = std::move(manifold);
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

/// Ends near the unit sphere, moved onto the domain.
Problem on(const std::shared_ptr<const ConstraintManifold>& manifold) {
  Problem problem = between(manifold);
  problem.source = project_end(*manifold, problem.source.u);
  problem.target = project_end(*manifold, problem.target.u);
  return problem;
}

Problem grid() {
  SignedDistanceOptions options;
  options.source = distance_source::Implicit{.surface = {.surface = implicit::Sphere{}}};
  options.cell = 0.05;
  return on(make_signed_distance_manifold(options, ""));
}

Problem chute() {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{});
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(std::numbers::pi, -2);
  problem.cost = make_travel_time_cost({.gravity = 1}, 2, problem.source.u);
  problem.kernel = make_kernel<Expm1Square>();
  return problem;
}

std::vector<Row> rows() {
  const auto straight = std::make_shared<const StraightInitializer>();
  const auto dijkstra = std::make_shared<const DijkstraInitializer>();
  FindOptions traced;
  traced.post_processors = {std::make_shared<const TracePostProcessor>(),
                            std::make_shared<const StraightenPostProcessor>()};
  std::vector<Row> all = {{"plane", chute(), straight, {}},
                          {"sphere", on(std::make_shared<test::Sphere>()), straight, {}},
                          {"chart",
                           between(make_parametric_manifold({.surface = parametric::Torus{}}), Eigen::Vector2d(0, 0.5),
                                   Eigen::Vector2d(2, -1)),
                           straight,
                           {}},
                          {"grid", grid(), straight, {}}};
  for (const int levels : {5, 7, 8}) {
    const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(test::sphere(levels)));
    const std::string size = std::to_string((mesh->mesh().vertex_count() + 500) / 1000) + "K";
    all.push_back({"mesh " + size, on(mesh), dijkstra, traced});
  }
  const auto cloud = std::make_shared<const PointCloudManifold>(PointCloud(test::sphere_cloud(20000), {}));
  all.push_back({"cloud 20K", on(cloud), dijkstra, {}});
  prepare(all.back().problem);
  return all;
}

/// The 99th of 100, seconds.
double overrun_of(const Row& row, const Solver& solver, int points, double budget) {
  FindOptions options = row.options;
  options.points = points;
  std::vector<double> seconds;
  for (int i = 0; i < 100; ++i) {
    Monitor monitor;
    monitor.deadline = Monitor::Clock::now() + std::chrono::duration_cast<Monitor::Clock::duration>(
                                                   std::chrono::duration<double>(budget * (0.5 + i / 100.0)));
    seconds.push_back(
        test::overrun(*monitor.deadline, [&] { find_path(row.problem, *row.initializer, solver, options, monitor); }));
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[98];
}

}  // namespace

/// Arguments: a part of the names of the domains, and one of the solvers, that are asked for.
int main(int count, char** arguments) {
  std::vector<Column> columns = {{std::make_shared<const Newton>(), 1e-3}, {std::make_shared<const Lbfgs>(), 1e-3}};
#ifdef LEASTCOST_HAS_NLOPT
  columns.push_back({std::make_shared<const Nlopt>(), 5e-3});
#endif
#ifdef LEASTCOST_HAS_CERES
  columns.push_back({std::make_shared<const Ceres>(), 5e-3});
#endif
  int missed = 0;
  std::printf("%-10s %-7s %6s %9s %12s\n", "domain", "solver", "n", "budget", "p99 overrun");
  for (const Row& row : rows()) {
    if (count > 1 && row.name.find(arguments[1]) == std::string::npos) continue;
    for (const Column& column : columns) {
      if (count > 2 && column.solver->name().find(arguments[2]) == std::string::npos) continue;
      for (const int points : {20, 100, 1000, 10000})
        for (const double budget : {1e-3, 5e-3, 25e-3}) {
          const double over = overrun_of(row, *column.solver, points, budget);
          const bool met = over <= std::max(column.allowed, budget / 10);
          missed += met ? 0 : 1;
          std::printf("%-10s %-7s %6d %6.0f ms %9.3f ms  %s\n", row.name.c_str(),
                      std::string(column.solver->name()).c_str(), points, 1e3 * budget, 1e3 * over,
                      met ? "met" : "MISSED");
          std::fflush(stdout);
        }
    }
  }
  std::printf("%d missed\n", missed);
  return missed;
}
