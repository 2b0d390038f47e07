// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/solvers/newton.hpp>

#include <leastcost/framework/base/checked.hpp>
#include "framework/newton/chain_newton.hpp"
#include "solvers/limit_fields.hpp"

namespace leastcost {

void NewtonOptions::fields(FieldVisitor& visit) {
  tolerance_field(visit, tolerance);
  limit_fields(visit, max_iterations, max_evaluations);
}

Newton::Newton(NewtonOptions options) : options_(checked(options)) {}

SolveReport Newton::do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const {
  return solve_by_newton(energy, path, {options_.tolerance, options_.max_iterations, options_.max_evaluations},
                         monitor);
}

}  // namespace leastcost
