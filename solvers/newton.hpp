// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

struct NewtonOptions {
  double tolerance = 1e-14;      ///< relative cost error
  int max_iterations = 200;      ///< steps at most
  int max_evaluations = 100000;  ///< evaluations of the energy at most
  void fields(FieldVisitor& visit);
};

/// Block-tridiagonal Newton on the chain: exact Hessian where it is positive definite, the Gauss-Newton one for that
/// step otherwise, Armijo along the retraction with a slack for rounding. docs/numerics.md Sec. 3.2.
class Newton final : public Solver {
 public:
  explicit Newton(NewtonOptions options = {});
  std::string_view name() const override { return "newton"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  NewtonOptions options_;
};

}  // namespace leastcost
