// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/solvers/preconditioner.hpp>

namespace leastcost {

struct LbfgsOptions {
  double tolerance = 1e-14;      ///< relative cost error
  int max_iterations = 1000;     ///< steps at most
  int max_evaluations = 100000;  ///< evaluations of the energy at most
  int memory = 10;
  Preconditioner precondition = Preconditioner::chain;
  void fields(FieldVisitor& visit);
};

/// Riemannian limited-memory BFGS: retraction, vector transport by projection, weak-Wolfe search by bisection that
/// survives kinks (Lewis, Overton), H0 = inverse Gauss-Newton chain Hessian refactored every iteration
/// (`precondition: chain`) or a multiple of the identity (`none`). VFCS 4.3.3 with docs/numerics.md Sec. 3.4.
class Lbfgs final : public Solver {
 public:
  explicit Lbfgs(LbfgsOptions options = {});
  std::string_view name() const override { return "lbfgs"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  LbfgsOptions options_;
};

}  // namespace leastcost
