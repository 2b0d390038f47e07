// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/stopping.hpp>

namespace leastcost {

/// Weights w >= 0, sum 1, that minimise |sum_j w_j g_j|^2 + 2 sum_j w_j penalty_j for vectors with Gram matrix `gram`:
/// without penalties the shortest element of their hull (active set, Wolfe 1976).
Eigen::VectorXd shortest_in_hull(const Eigen::MatrixXd& gram, const Eigen::VectorXd& penalties);

/// One step of a bundle method at a path where the energy may have a kink (a polyhedron: the foot point of a segment
/// crosses an edge, and the gradient jumps). Collects gradients around the path until the shortest element of their
/// hull either gives a step that lowers the energy or is short itself: then the path is stationary although no single
/// gradient is small (docs/numerics.md Secs. 3.1, 5.1, 6.6; Lewis, Overton).
struct BundleStep {
  bool lowered = false;   ///< `path` was replaced by a better one
  double cost_error = 0;  ///< predicted relative cost error from the shortest element
  double decrease = 0;    ///< of the energy, where lowered
};
BundleStep bundle_step(PathEnergy& energy, CoordinatePath& path, double tolerance, int most_gradients = 40);

/// Relative cost error at which a path on a polyhedron counts as stationary; the certificate allows ten times as much.
inline constexpr double kKinkedTolerance = 1e-7;
/// A step that gains less than this part of what the chain model predicted has run into a kink.
inline constexpr double kKinkedGain = 0.1;

/// The last part of every solve on a polyhedron: bundle steps until the shortest element is below kKinkedTolerance.
/// Ends the loop with its report.
SolveReport descend_by_bundles(PathEnergy& energy, CoordinatePath& path, SolveLoop& loop);

}  // namespace leastcost
