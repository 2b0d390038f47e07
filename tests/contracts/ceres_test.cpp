// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/ceres/ceres_solver.hpp>

#include "tests/contracts/solver_contract.hpp"

namespace leastcost::test {
namespace {

MakeSolver ceres(const char* algorithm, const char* precondition = "chain") {
  return [=](int iterations, int evaluations) {
    CeresOptions options{.algorithm = algorithm, .max_iterations = iterations};
    options.rounds.precondition = precondition;
    options.rounds.max_evaluations = evaluations;
    return std::make_unique<Ceres>(options);
  };
}

}  // namespace

TEST_CASE("solver contract: ceres, trust region", "[contract]") {
  const char* algorithm = GENERATE("levenberg_marquardt", "dogleg");
  CAPTURE(algorithm);
  check_solver_contract(ceres(algorithm));
}
TEST_CASE("solver contract: ceres, line search, precondition chain", "[contract]") {
  const char* algorithm = GENERATE("lbfgs", "bfgs", "ncg");
  CAPTURE(algorithm);
  check_solver_contract(ceres(algorithm), {.has_iterations = false});
}
TEST_CASE("solver contract: ceres, line search, precondition none", "[contract]") {
  check_solver_contract(ceres("lbfgs", "none"), {.has_iterations = false});
}
TEST_CASE("solvers agree: newton and ceres", "[contract]") {
  const char* algorithm = GENERATE("levenberg_marquardt", "dogleg", "lbfgs");
  CAPTURE(algorithm);
  check_agreement(Newton(), *ceres(algorithm)(1000, 1000000));
}

}  // namespace leastcost::test
