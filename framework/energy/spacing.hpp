// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// max c / min c - 1; 0 when all are equal, +infinity when one vanishes.
double spread(const Eigen::VectorXd& costs);

/// Throws the InitializationError of a path with an infinite cost, for its first such segment; returns where there is
/// none. `x`: ambient, one column more than costs.
void refuse_infinite(const Problem& problem, const Points& x, const Eigen::VectorXd& costs);

/// Samples a polyline at n free points, equally spaced in cost: up to `passes` passes of O(n) until the spread is below
/// `tolerance`. An exponential kernel overflows, and Newton needs 20 times as many iterations, from a path that is not
/// (docs/numerics.md Sec. 1.3). The points are projected onto the manifold. Throws InitializationError when the cost
/// stays infinite or the polyline has no length, Interrupted when it meets the deadline before the first samples of
/// finite cost are there; later the best of them are returned.
CoordinatePath sample_equally(const Problem& problem, const CoordinatePath& polyline, int points,
                              double tolerance = 0.05, int passes = 8, const Deadline& deadline = {});

/// The same at equal lengths, whatever the moves between the points cost.
CoordinatePath sample_evenly(const Problem& problem, const CoordinatePath& polyline, int points,
                             const Deadline& deadline = {});

/// Twice as many segments: a midpoint in each, by 4-point cubic interpolation (quadratic at the ends), projected onto
/// the manifold. Where that lands outside the domain of the cost, linear midpoints.
CoordinatePath refine(const Problem& problem, const CoordinatePath& path, const Deadline& deadline = {});

}  // namespace leastcost
