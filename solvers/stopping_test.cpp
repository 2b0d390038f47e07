// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/stopping_test.hpp"

#include <algorithm>
#include <limits>

#include <leastcost/framework/energy/stopping.hpp>
#include "framework/newton/bundle.hpp"

namespace leastcost {

bool StoppingTest::holds(PathEnergy& energy, const CoordinatePath& path, const ChainModel& at, int iteration) {
  next_ = iteration + 10 + iteration / 10;
  ChainModel model = at;
  model.solve(energy, path, HessianKind::exact);
  cost_error_ = model.cost_error;
  if (energy.problem().manifold->shape() == Shape::polyhedral)
    return cost_error_ <= std::max(kKinkedTolerance, tolerance_);
  const bool right_model = !energy.has_exact_hessian() || (model.exact && model.spacing_error <= kSpacingTolerance);
  return right_model && cost_error_ <= tolerance_;
}

double measured_cost_error(PathEnergy& energy, const CoordinatePath& path) {
  ChainModel model;
  if (!model.evaluate(energy, path)) return std::numeric_limits<double>::infinity();
  model.solve(energy, path, HessianKind::exact);
  return model.cost_error;
}

}  // namespace leastcost
