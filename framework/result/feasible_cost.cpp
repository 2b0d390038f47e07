// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/result/feasible_cost.hpp"

#include <cmath>
#include <limits>

#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/energy/curve_value.hpp"
#include "framework/energy/spacing.hpp"

namespace leastcost {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kUneven = 4;  ///< largest over mean segment of a curve that lies on the domain all along

/// The points joined along a curved domain: chords of two dense chains, extrapolated.
double projected_cost(const Problem& problem, const CoordinatePath& path, const Deadline& deadline) {
  PathEnergy energy(problem, 1, deadline);
  const CoordinatePath dense = refine(problem, refine(problem, path, deadline), deadline);
  const Eigen::VectorXd costs = energy.costs(refine(problem, dense, deadline));
  if (!(costs.maxCoeff() <= kUneven * costs.mean()))
    return kNone;  // a move that no point between its ends could shorten
  return (4 * costs.sum() - energy.cost(dense)) / 3;
}

double cost_of_curve(const Problem& problem, const Result& result, const Deadline& deadline) {
  const Shape shape = problem.manifold->shape();
  if (result.certificate.measured && result.certificate.estimate.upper) return *result.certificate.estimate.upper;
  if (shape == Shape::polyhedral || (shape == Shape::flat && problem.cost->traits().additive)) return result.curve.cost;
  const bool chart = find_ability<HasChart>(*problem.manifold) != nullptr;
  if (shape == Shape::smooth && !chart) return projected_cost(problem, result.path, deadline);
  return smooth_curve_cost(problem, result.path, deadline).value_or(result.curve.cost);
}

}  // namespace

double feasible_cost(const Problem& problem, const Result& result, const Deadline& deadline) {
  if (result.path.u.size() == 0 || result.status == Status::collapsed) return kNone;
  const double cost = cost_of_curve(problem, result, deadline);
  return std::isfinite(cost) && cost > 0 ? cost : kNone;
}

}  // namespace leastcost
