// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// One geodesic on a torus, every solver from the same first path, judged by the same stopping test and certificate.
#include <cstdio>
#include <memory>
#include <vector>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/solvers/ceres/ceres_solver.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>

int main() {
  using namespace leastcost;
  Problem problem;
  problem.manifold = make_parametric_manifold({.surface = parametric::Torus{}});
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Square>();
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(1, 2);

  const Newton newton;
  const Lbfgs lbfgs;
  const Nlopt nlopt({.algorithm = NloptAlgorithm::lbfgs});
  const Ceres ceres({.algorithm = CeresAlgorithm::levenberg_marquardt});
  int uncertified = 0;
  for (const Solver* solver : std::vector<const Solver*>{&newton, &lbfgs, &nlopt, &ceres}) {
    const Result result = find_path(problem, StraightInitializer(), *solver, {.points = 200});
    const Counters& work = result.solve.counters;
    std::printf("%-6s %-12s %-10s %.12f  %3ld evaluations, %.1f ms\n", std::string(solver->name()).c_str(),
                word_of(result.status).data(), word_of(result.solve.termination).data(),
                result.certificate.estimate.value, work.energies + work.gradients, 1e3 * result.solve.seconds);
    if (!result.certificate.certified()) ++uncertified;
  }
  return uncertified;
}
