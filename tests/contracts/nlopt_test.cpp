// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>

#include "tests/contracts/solver_contract.hpp"
#include "tests/support/choices.hpp"

namespace leastcost::test {
namespace {

using enum NloptAlgorithm;

MakeSolver nlopt_solver(NloptAlgorithm algorithm, Preconditioner precondition = Preconditioner::chain) {
  return [=](int, int evaluations) {
    NloptOptions options{.algorithm = algorithm};
    options.rounds.precondition = precondition;
    options.rounds.max_evaluations = evaluations;
    return std::make_unique<Nlopt>(options);
  };
}

constexpr Promise kBackEnd = {.has_iterations = false};

template <class Options>
concept TakesMisspelt = requires {
  Options{.algorithm = "lbfg"};
};
static_assert(!TakesMisspelt<NloptOptions>);
static_assert(!kTakesWords<decltype(NloptOptions::algorithm)>);

}  // namespace

TEST_CASE("typed options: every algorithm of nlopt has one word") { check_words(NloptAlgorithm::praxis); }
TEST_CASE("solver contract: nlopt, precondition chain", "[contract]") {
  const NloptAlgorithm algorithm = GENERATE(lbfgs, tnewton, tnewton_restart, tnewton_precond, tnewton_precond_restart,
                                            var1, var2, mma, ccsaq, slsqp);
  CAPTURE(word_of(algorithm));
  check_solver_contract(nlopt_solver(algorithm), kBackEnd);
}
TEST_CASE("solver contract: nlopt, precondition none", "[contract][slow_sanitized]") {
  const NloptAlgorithm algorithm = GENERATE(lbfgs, tnewton_precond_restart, var2, slsqp);
  CAPTURE(word_of(algorithm));
  check_solver_contract(nlopt_solver(algorithm, Preconditioner::none), kBackEnd);
}
TEST_CASE("solver contract: nlopt, without gradients", "[contract][slow_sanitized]") {
  const NloptAlgorithm algorithm = GENERATE(cobyla, bobyqa, neldermead, sbplx, praxis);
  CAPTURE(word_of(algorithm));
  constexpr int kEnough = 5000;  // they promise no convergence
  const MakeSolver make = nlopt_solver(algorithm);
  check_solver_contract(
      [&](int iterations, int evaluations) { return make(iterations, std::min(evaluations, kEnough)); },
      {.has_iterations = false, .converges = false});
}
TEST_CASE("solvers agree: newton and nlopt", "[contract]") {
  const Preconditioner precondition = GENERATE(Preconditioner::chain, Preconditioner::none);
  check_agreement(Newton(), *nlopt_solver(lbfgs, precondition)(0, 1000000));
}
TEST_CASE("nlopt: dense methods are refused above a stated size", "[contract]") {
  const StandardProblem p = standard_problems().front();
  CoordinatePath path = p.start;
  path.u.conservativeResize(2, 300);  // 596 variables
  const std::optional<std::string> reason = nlopt_solver(slsqp)(0, 10)->cannot_solve(energy_at_mean(p), path);
  REQUIRE(reason);
  CHECK(reason->find("at most 500 variables, but this path has 596") != std::string::npos);
  CHECK_FALSE(nlopt_solver(lbfgs)(0, 10)->cannot_solve(energy_at_mean(p), path));
}

}  // namespace leastcost::test
