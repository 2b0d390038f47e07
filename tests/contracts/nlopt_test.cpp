// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>

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
  constexpr int kEnough = 5000;  // they promise no convergence
  const MakeSolver make = nlopt(algorithm);
  check_solver_contract(
      [&](int iterations, int evaluations) { return make(iterations, std::min(evaluations, kEnough)); },
      {.has_iterations = false, .converges = false});
}
TEST_CASE("solvers agree: newton and nlopt", "[contract]") {
  const std::string precondition = GENERATE("chain", "none");
  check_agreement(Newton(), *nlopt("lbfgs", precondition.c_str())(0, 1000000));
}
TEST_CASE("nlopt: dense methods are refused above a stated size", "[contract]") {
  const StandardProblem p = standard_problems().front();
  CoordinatePath path = p.start;
  path.u.conservativeResize(2, 300);  // 596 variables
  const std::optional<std::string> reason = nlopt("slsqp")(0, 10)->cannot_solve(energy_at_mean(p), path);
  REQUIRE(reason);
  CHECK(reason->find("at most 500 variables, this path has 596") != std::string::npos);
  CHECK_FALSE(nlopt("lbfgs")(0, 10)->cannot_solve(energy_at_mean(p), path));
}

}  // namespace leastcost::test
