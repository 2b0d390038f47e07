// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/path_energy.hpp>

namespace leastcost {

/// The quadratic model of the energy at a path: gradient, frames, factored chain Hessian. What Newton steps with, what
/// preconditions L-BFGS, and what measures stationarity, for every solver alike.
struct ChainModel {
  double value = 0;          ///< energy of the chain
  Points gradient;           ///< coordinate x n
  Frames frames;             ///< tangent frames at the free points
  Eigen::VectorXd tangent;   ///< gradient in the frames, blocked directions 0
  ChainSystem system;        ///< gradient and Hessian in these frames
  bool exact = false;        ///< the exact Hessian factored; otherwise the Gauss-Newton one did
  Eigen::VectorXd step;      ///< -H^-1 g in the frames
  Points moves;              ///< the same in coordinates, coordinate x n
  double decrement = 0;      ///< g' H^-1 g
  double cost_error = 0;     ///< decrement / (2 sum H'(s_i) s_i), docs/numerics.md Sec. 3.1
  double spacing_error = 0;  ///< largest relative change of a segment by the step

  /// value, gradient, frames and tangent gradient at a path. False where the energy is not finite.
  bool evaluate(PathEnergy& energy, const CoordinatePath& path);
  /// Factors the exact Hessian, or the Gauss-Newton one where that is not wanted or not positive definite, lifted until
  /// it factors; fills step, decrement and the errors.
  void solve(PathEnergy& energy, const CoordinatePath& path, HessianKind wanted);
};

/// The Gauss-Newton Hessian does not see a ring drift, all points moved alike, which the exact one prices by the
/// curvature of domain and cost: lifted by the stiffness of one wave around the ring, the model is as good there as
/// elsewhere.
void lift_drift(ChainSystem& system);

/// What rounding leaves undecided in an energy difference: 4 eps sqrt(N) |E|.
double rounding_slack(double value, Index segments);

/// Sufficient decrease: a step t along a slope must gain kArmijo t |slope| (Nocedal & Wright, Eq. 3.4).
inline constexpr double kArmijo = 1e-4;

}  // namespace leastcost
