// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/energy/stopping.hpp>

namespace leastcost {

inline constexpr Limits kChainNewtonLimits{1e-14, 200, 100000};

/// Block-tridiagonal Newton on the chain: exact Hessian where it is positive definite, the Gauss-Newton one for that
/// step otherwise, Armijo along the retraction with a slack for rounding. docs/numerics.md Sec. 3.2. It is the solver
/// `newton`, and with fixed limits what the certificate solves by, whatever made the path.
SolveReport solve_by_newton(PathEnergy& energy, CoordinatePath& path, const Limits& limits, const Monitor& monitor);

class ChainNewton final : public Solver {
 public:
  std::string_view name() const override { return "newton"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
};

}  // namespace leastcost
