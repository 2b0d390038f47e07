// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/georce.hpp>
#include <leastcost/solvers/gradient_descent.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include <leastcost/solvers/string_method.hpp>
#include <leastcost/solvers/vfcs.hpp>
#include "tests/contracts/solver_contract.hpp"

namespace leastcost::test {
namespace {

std::unique_ptr<Solver> newton(int iterations, int evaluations) {
  return std::make_unique<Newton>(NewtonOptions{.max_iterations = iterations, .max_evaluations = evaluations});
}
std::unique_ptr<Solver> make_lbfgs(int iterations, int evaluations, Preconditioner precondition) {
  return std::make_unique<Lbfgs>(
      LbfgsOptions{.max_iterations = iterations, .max_evaluations = evaluations, .precondition = precondition});
}

}  // namespace

TEST_CASE("solver contract: newton", "[contract]") { check_solver_contract(newton); }
TEST_CASE("solver contract: lbfgs, precondition chain", "[contract]") {
  check_solver_contract(
      [](int iterations, int evaluations) { return make_lbfgs(iterations, evaluations, Preconditioner::chain); });
}
TEST_CASE("solver contract: lbfgs, precondition none", "[contract]") {
  check_solver_contract(
      [](int iterations, int evaluations) { return make_lbfgs(iterations, evaluations, Preconditioner::none); });
}
TEST_CASE("solver contract: gradient_descent", "[contract][slow_sanitized]") {
  check_solver_contract([](int iterations, int evaluations) {
    return std::make_unique<GradientDescent>(
        GradientDescentOptions{.max_iterations = iterations, .max_evaluations = evaluations});
  });
}
TEST_CASE("solver contract: vfcs", "[contract]") {
  check_solver_contract(
      [](int iterations, int evaluations) {
        return std::make_unique<Vfcs>(VfcsOptions{.max_iterations = iterations, .max_evaluations = evaluations});
      },
      {.own_rule = true});
}
TEST_CASE("solver contract: georce", "[contract]") {
  check_solver_contract(
      [](int iterations, int evaluations) {
        return std::make_unique<Georce>(GeorceOptions{.max_iterations = iterations, .max_evaluations = evaluations});
      },
      {.own_rule = true, .by_cost = true});
}
TEST_CASE("solver contract: string", "[contract][slow_sanitized]") {
  check_solver_contract(
      [](int iterations, int evaluations) {
        return std::make_unique<StringMethod>(
            StringMethodOptions{.tolerance = 1e-6, .max_iterations = iterations, .max_evaluations = evaluations});
      },
      {.own_rule = true, .by_cost = true});
}
TEST_CASE("solver contract: none", "[contract]") {
  for (const StandardProblem& p : standard_problems()) {
    CAPTURE(p.name);
    PathEnergy energy = energy_at_mean(p);
    CoordinatePath path = p.start;
    const SolveReport report = NoSolver().solve(energy, path, {});
    CHECK(path.u == p.start.u);
    CHECK(report.termination == Termination::fixed_point);
    CHECK(report.iterations == 0);
    CHECK(report.final_energy == report.initial_energy);
  }
  Problem faulty = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  CoordinatePath path;
  path.u = Eigen::Matrix2Xd{{0, std::numeric_limits<double>::infinity(), 1}, {0, 0, 0}};
  PathEnergy energy(faulty, 1);
  CHECK(NoSolver().solve(energy, path, {}).termination == Termination::non_finite);
}
TEST_CASE("solvers agree", "[contract]") {
  const auto n = newton(1000, 100000), chain = make_lbfgs(1000, 100000, Preconditioner::chain),
             plain = make_lbfgs(100000, 1000000, Preconditioner::none);
  check_agreement(*n, *chain);
  check_agreement(*n, *plain);
}

}  // namespace leastcost::test
