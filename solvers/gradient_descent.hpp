// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

struct GradientDescentOptions {
  double tolerance = 1e-14;      ///< relative cost error
  int max_iterations = 20000;    ///< steps at most
  int max_evaluations = 100000;  ///< evaluations of the energy at most
  void fields(FieldVisitor& visit);
};

/// Riemannian steepest descent: along the projected gradient (VFCS Eq. 11) and back onto the domain, Armijo by halving
/// from twice the last step. The plainest method there is; its iterations grow with the square of the number of points,
/// which is what it is here to show.
class GradientDescent final : public Solver {
 public:
  explicit GradientDescent(GradientDescentOptions options = {}) : options_(checked(options)) {}
  std::string_view name() const override { return "gradient_descent"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  GradientDescentOptions options_;
};

}  // namespace leastcost
