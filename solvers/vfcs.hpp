// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

struct VfcsOptions {
  double gradient_tolerance = 1e-8;
  int max_iterations = 20000;    ///< steps at most
  int max_evaluations = 100000;  ///< evaluations of the energy at most
  int memory = 10;
  void fields(FieldVisitor& visit);
};

/// VFCS Algorithm 1 as printed, for comparison: L-BFGS on the points in their ambient coordinates, projected onto the
/// domain after every step, gradients projected onto the tangent planes (Eq. 11), no vector transport, no
/// preconditioner; ends when the norm of the projected gradient is at most 1e-8 (Sec. 4.3.3). That is no rule for
/// "converged" (it depends on the number of points and the unit of the cost: docs/numerics.md Sec. 3.1), so the end is
/// called fixed_point and the relative cost error is measured there. What the paper leaves open: ten stored pairs,
/// Armijo by halving, first step a tenth of a segment. Its energies are those of `reference_cost: 1`.
class Vfcs final : public Solver {
 public:
  explicit Vfcs(VfcsOptions options = {}) : options_(checked(options)) {}
  std::string_view name() const override { return "vfcs"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  VfcsOptions options_;
};

}  // namespace leastcost
