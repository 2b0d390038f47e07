// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include <leastcost/framework/check/faults.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

struct CheckManifoldOptions {
  int samples = 12;  ///< random places that are tried
  double size = 1;   ///< extent of the domain, length units: rounding is 1e-14 of it
  double step = 1;   ///< longest step that is tried, length units; well below the radius of curvature
  std::vector<Eigen::VectorXd> special = {};  ///< further points: on an edge, a corner, a bound, and 1e-8 beside it
};

/// What a manifold promises (ConstraintManifold and its abilities), measured at points near it (in its coordinates). No
/// fault found is no proof. Deterministic for a given engine; prints nothing; throws what the manifold throws. Names:
///
///     dimensions       tangent > coordinate, or a basis of another size
///     projection       a point near the domain has no nearest one, or `moved` is not the distance there
///     residual         not zero after project() or retract(), or not the distance before
///     idempotent       a feasible point is moved again
///     tangent_bases    T'T is not the identity, or (smooth) x + h t leaves the domain at first order
///     retraction       R(x, 0) is not x, dR(x, 0) not the identity (Taylor slope 2), or the fixed ends of a path move
///     second_order     (smooth, no chart) R(x, h t) and the nearest point to x + h t differ at second order already:
///                      the exact Hessian takes the curvature of the domain from there
///     bounds           a normal is no unit vector, points inwards, or the bound does not hold
///     chart_jacobian, chart_curvature        are not the differences of the embedding
///     chart_poles      the image of a point over a pole is embedded elsewhere
std::vector<Fault> check_manifold(const ConstraintManifold& manifold, const PointSampler& near, std::mt19937_64& engine,
                                  const CheckManifoldOptions& options = {});

}  // namespace leastcost
