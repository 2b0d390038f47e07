// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Iterations and time of the chain solvers against the number of points, and against plain L-BFGS. One run, ratios.
#include <cstdio>
#include <limits>
#include <numbers>
#include <vector>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include "benchmarks/measure.hpp"
#include "framework/newton/cascade.hpp"
#include "tests/support/half_plane.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;

Problem in_plane(Eigen::Vector2d source, Eigen::Vector2d target, std::shared_ptr<const SegmentCost> cost) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{});
  problem.cost = std::move(cost);
  problem.source.u = source;
  problem.target.u = target;
  return problem;
}

Problem chute(double start_speed, Eigen::Vector2d target) {
  TravelTimeOptions options;
  options.gravity = 1;
  options.start_speed = start_speed;
  const Eigen::Vector2d source = Eigen::Vector2d::Zero();
  return in_plane(source, target, make_travel_time_cost(options, 2, source));
}

Solve cascade(std::shared_ptr<const Solver> solver) {
  return [solver](const Problem& problem, CoordinatePath& path, double s0) {
    Problem fitted = problem;
    return solve_by_cascade(fitted, *solver, s0, path, {});
  };
}

void table(std::vector<Case>& cases) {
  const std::vector<int> sizes = {20, 200, 2000, 20000};
  print_heading(sizes);
  const std::vector<std::pair<const char*, Solve>> solvers = {{"newton", direct(std::make_shared<Newton>())},
                                                              {"lbfgs chain", direct(std::make_shared<Lbfgs>())},
                                                              {"newton, cascade", cascade(std::make_shared<Newton>())}};
  for (Case& c : cases)
    for (const auto& [kernel_name, kernel] :
         {std::pair{"square", make_kernel<Square>()}, std::pair{"expm1_square", make_kernel<Expm1Square>()}})
      for (const auto& [name, solve] : solvers) {
        c.problem.kernel = kernel;
        std::vector<Outcome> row;
        for (const int n : sizes) row.push_back(measure(c, n, solve, n > 2000 ? 3 : 5));
        print_row(c.name, kernel_name, name, sizes, row);
      }
}

void against_plain(std::vector<Case>& cases) {
  std::printf(
      "\nAgainst plain L-BFGS at n = 1000, same tolerance (relative cost error 1e-14, confirmed by the chain "
      "Hessian)\n");
  LbfgsOptions options;
  options.precondition = Preconditioner::none;
  options.max_iterations = 20000;
  options.max_evaluations = 100000;
  for (Case& c : cases) {
    c.problem.kernel = make_kernel<Expm1Square>();
    const Outcome plain = measure(c, 1000, direct(std::make_shared<Lbfgs>(options)), 1);
    const Outcome chain = measure(c, 1000, direct(std::make_shared<Lbfgs>()), 5);
    const Outcome newton = measure(c, 1000, direct(std::make_shared<Newton>()), 5);
    std::printf(
        "| %-12s | plain %6d it%s %9.1f ms | chain %7.2f ms, %6.0f x faster | newton %7.2f ms, %6.0f x faster |\n",
        c.name, plain.iterations, plain.end == Termination::converged ? "" : "*", plain.milliseconds,
        chain.milliseconds, plain.milliseconds / chain.milliseconds, newton.milliseconds,
        plain.milliseconds / newton.milliseconds);
  }
}

}  // namespace

int main() {
  std::vector<Case> cases = {{"chute, rest", chute(0, {std::numbers::pi, -2})},
                             {"chute, moving", chute(1, {1, -1})},
                             {"half-plane", in_plane({0, 1}, {2, 3}, make_segment_cost(test::HalfPlane{}))}};
  table(cases);
  against_plain(cases);
}
