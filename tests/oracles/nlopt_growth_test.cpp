// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/nlopt/nlopt_solver.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/growth.hpp"

namespace leastcost::test {

TEST_CASE("nlopt in the chain's variables: evaluations do not grow with n", "[oracle]") {
  using enum NloptAlgorithm;
  const NloptAlgorithm algorithm =
      GENERATE(lbfgs, var1, var2, tnewton, tnewton_restart, tnewton_precond, tnewton_precond_restart, ccsaq);
  CAPTURE(word_of(algorithm));
  check_flat(Nlopt({.algorithm = algorithm}));
}

TEST_CASE("nlopt mma in the chain's variables: 2 to 4 rounds of 20 evaluations on the chute from rest", "[oracle]") {
  check_flat(Nlopt({.algorithm = NloptAlgorithm::mma}), 3);
}

TEST_CASE("nlopt without the chain: evaluations grow with n", "[oracle]") {
  NloptOptions plain{.algorithm = NloptAlgorithm::lbfgs};
  plain.rounds.precondition = Preconditioner::none;
  const Problem torus = growth_problems().front().second;
  CHECK(evaluations_to_solve(torus, 160, Nlopt(plain)) > 4 * evaluations_to_solve(torus, 20, Nlopt(plain)));
}

}  // namespace leastcost::test
