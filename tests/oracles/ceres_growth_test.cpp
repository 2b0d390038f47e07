// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/ceres/ceres_solver.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/growth.hpp"

namespace leastcost::test {

TEST_CASE(
    "ceres: evaluations do not grow with n, by the trust region as it is, by line search in the chain's variables",
    "[oracle]") {
  using enum CeresAlgorithm;
  const CeresAlgorithm algorithm = GENERATE(levenberg_marquardt, dogleg, lbfgs, ncg);
  CAPTURE(word_of(algorithm));
  check_flat(Ceres({.algorithm = algorithm}));
}

}  // namespace leastcost::test
