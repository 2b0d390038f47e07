// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/ceres/ceres_solver.hpp>

#include "tests/contracts/solver_contract.hpp"
#include "tests/support/choices.hpp"

namespace leastcost::test {
namespace {

using enum CeresAlgorithm;

MakeSolver ceres_solver(CeresAlgorithm algorithm, Preconditioner precondition = Preconditioner::chain) {
  return [=](int iterations, int evaluations) {
    CeresOptions options{.algorithm = algorithm, .max_iterations = iterations};
    options.rounds.precondition = precondition;
    options.rounds.max_evaluations = evaluations;
    return std::make_unique<Ceres>(options);
  };
}

template <class Options>
concept TakesMisspelt = requires {
  Options{.algorithm = "lbfg"};
};
static_assert(!TakesMisspelt<CeresOptions>);
static_assert(!kTakesWords<decltype(CeresOptions::algorithm)>);

}  // namespace

TEST_CASE("typed options: every algorithm of ceres has one word") { check_words(CeresAlgorithm::ncg); }
TEST_CASE("solver contract: ceres, trust region", "[contract]") {
  const CeresAlgorithm algorithm = GENERATE(levenberg_marquardt, dogleg);
  CAPTURE(word_of(algorithm));
  check_solver_contract(ceres_solver(algorithm));
}
TEST_CASE("solver contract: ceres, line search, precondition chain", "[contract]") {
  const CeresAlgorithm algorithm = GENERATE(lbfgs, bfgs, ncg);
  CAPTURE(word_of(algorithm));
  check_solver_contract(ceres_solver(algorithm), {.has_iterations = false});
}
TEST_CASE("solver contract: ceres, line search, precondition none", "[contract]") {
  check_solver_contract(ceres_solver(lbfgs, Preconditioner::none), {.has_iterations = false});
}
TEST_CASE("solvers agree: newton and ceres", "[contract]") {
  const CeresAlgorithm algorithm = GENERATE(levenberg_marquardt, dogleg, lbfgs);
  CAPTURE(word_of(algorithm));
  check_agreement(Newton(), *ceres_solver(algorithm)(1000, 1000000));
}

}  // namespace leastcost::test
