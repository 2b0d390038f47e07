// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// max c / min c - 1; 0 when all are equal, +infinity when one vanishes.
double spread(const Eigen::VectorXd& costs);

/// Throws the InitializationError of a path with an infinite cost, for its first such segment; returns where there is
/// none. `x`: ambient, one column more than costs.
void refuse_infinite(const Problem& problem, const Points& x, const Eigen::VectorXd& costs);

/// How points are placed along a path: up to `passes` passes of O(n) until the spread of the costs is below
/// `tolerance`.
struct Sampling {
  static constexpr int kPasses = 8;
  Sampling(int free_points, double spread = 0.05, int most_passes = kPasses)  // NOLINT: a number of points is one
      : points(free_points), tolerance(spread), passes(most_passes) {}
  int points;  ///< n >= 1
  double tolerance;
  int passes;
};

/// A chain, or in words why there is no such chain.
struct MaybeChain {
  std::optional<CoordinatePath> chain;
  std::string why_not;

  explicit operator bool() const { return chain.has_value(); }
  /// The chain; throws InitializationError where there is none.
  CoordinatePath or_throw() &&;
};

/// Samples a polyline at n free points, equally spaced in cost. From a path that is not, an exponential kernel
/// overflows, and Newton needs 20 times as many iterations (docs/numerics.md Sec. 1.3). The points are projected onto
/// the manifold. There is no chain when the cost stays infinite or the polyline has no length. Throws Interrupted when
/// it meets the deadline before the first samples of finite cost are there; later the best of them are returned.
MaybeChain try_sampling(const Problem& problem, const CoordinatePath& polyline, const Sampling& sampling,
                        const Deadline& deadline = {});

/// The same where there has to be a chain: throws InitializationError when there is none.
CoordinatePath sample_equally(const Problem& problem, const CoordinatePath& polyline, const Sampling& sampling,
                              const Deadline& deadline = {});

/// The same at equal lengths, whatever the moves between the points cost.
CoordinatePath sample_evenly(const Problem& problem, const CoordinatePath& polyline, int points,
                             const Deadline& deadline = {});

/// Twice as many segments: a midpoint in each, by 4-point cubic interpolation (quadratic at the ends), projected onto
/// the manifold. Where that lands outside the domain of the cost, linear midpoints.
CoordinatePath refine(const Problem& problem, const CoordinatePath& path, const Deadline& deadline = {});

}  // namespace leastcost
