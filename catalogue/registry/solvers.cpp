// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/solvers/georce.hpp>
#include <leastcost/solvers/gradient_descent.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include <leastcost/solvers/no_solver.hpp>
#include <leastcost/solvers/string_method.hpp>
#include <leastcost/solvers/vfcs.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

const std::vector<SolverPlugin>& built_in::solvers() {
  static const std::vector<SolverPlugin> own = {
      made_of<SolverPlugin, Newton, NewtonOptions>("newton", "Block-tridiagonal Newton on the chain."),
      made_of<SolverPlugin, Lbfgs, LbfgsOptions>("lbfgs", "Riemannian L-BFGS, preconditioned by the chain Hessian."),
      made_of<SolverPlugin, GradientDescent, GradientDescentOptions>("gradient_descent",
                                                                     "Riemannian steepest descent."),
      made_of<SolverPlugin, Vfcs, VfcsOptions>("vfcs", "Algorithm 1 of VFCS as printed, including its stopping rule."),
      made_of<SolverPlugin, Georce, GeorceOptions>(
          "georce",
          "GEORCE (arXiv 2505.05961): alternates between the optimality conditions of a discrete energy in a chart."),
      made_of<SolverPlugin, StringMethod, StringMethodOptions>(
          "string", "The string method: steps normal to the path, then equal spacing; no energy."),
      made_of<SolverPlugin, NoSolver>("none",
                                      "The first path unchanged, for post-processors that find the shortest one."),
  };
  static const std::vector<SolverPlugin> all = built_in::with_those_of_libraries(own, back_ends());
  return all;
}

}  // namespace leastcost
