// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What is known of the solver without its library: a program that loads the library late is linked with this alone.
#include <ceres/version.h>

#include <array>

#include <leastcost/solvers/ceres/ceres_solver.hpp>

namespace leastcost {

Words<CeresAlgorithm> words(CeresAlgorithm) {
  static constexpr std::array<Word<CeresAlgorithm>, 5> kWords = {
      {{CeresAlgorithm::levenberg_marquardt, "levenberg_marquardt"},
       {CeresAlgorithm::dogleg, "dogleg"},
       {CeresAlgorithm::lbfgs, "lbfgs"},
       {CeresAlgorithm::bfgs, "bfgs"},
       {CeresAlgorithm::ncg, "ncg"}}};
  return kWords;
}

void CeresOptions::fields(FieldVisitor& visit) {
  visit.choice("algorithm", algorithm,
               {.help = "Trust region (the first two) or line search; ncg: nonlinear conjugate gradients."});
  visit.field("max_iterations", max_iterations, {.help = "Limit on iterations of the trust region.", .minimum = 1});
  rounds.fields(visit);
}

std::string ceres_version() { return CERES_VERSION_STRING; }

}  // namespace leastcost
