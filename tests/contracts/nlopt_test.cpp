// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/nlopt/nlopt_solver.hpp"

#include "tests/contracts/solver_contract.hpp"

namespace leastcost::test {
namespace {

MakeSolver nlopt(const char* algorithm, const char* precondition = "chain") {
  return [=](int, int evaluations) {
    NloptOptions options{.algorithm = algorithm};
    options.rounds.precondition = precondition;
    options.rounds.max_evaluations = evaluations;
    return std::make_unique<Nlopt>(options);
  };
}

constexpr Promise kBackEnd = {.has_iterations = false};

}  // namespace

TEST_CASE("solver contract: nlopt, precondition chain", "[contract]") {
  const char* algorithm = GENERATE("lbfgs", "tnewton", "tnewton_restart", "tnewton_precond", "tnewton_precond_restart",
                                   "var1", "var2", "mma", "ccsaq", "slsqp");
  CAPTURE(algorithm);
  check_solver_contract(nlopt(algorithm), kBackEnd);
}
TEST_CASE("solver contract: nlopt, precondition none", "[contract]") {
  const char* algorithm = GENERATE("lbfgs", "tnewton_precond_restart", "var2", "slsqp");
  CAPTURE(algorithm);
  check_solver_contract(nlopt(algorithm, "none"), kBackEnd);
}
TEST_CASE("solver contract: nlopt, without gradients", "[contract]") {
  const char* algorithm = GENERATE("cobyla", "bobyqa", "neldermead", "sbplx", "praxis");
  CAPTURE(algorithm);
  check_solver_contract(nlopt(algorithm), {.has_iterations = false, .converges = false});
}

}  // namespace leastcost::test
