// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/path/kernel.hpp>

namespace leastcost {

/// An end of an open path, on the manifold.
struct PathEnd {
  Eigen::VectorXd u;    ///< coordinates
  Site site = kNoSite;  ///< face, cell or patch that u is in
};

/// What is minimised, and where: sum_i H(c(x_i, x_i+1) / s0) over points of a manifold between two fixed ends, or
/// over a ring (which has no ends).
struct Problem {
  std::shared_ptr<const ConstraintManifold> manifold;  ///< where points may be
  std::shared_ptr<const SegmentCost> cost;             ///< of a move between two points
  std::shared_ptr<const Kernel> kernel;                ///< the convex H of the sum
  PathEnd source, target;                              ///< ends of the path; of a ring the source alone, if `based`
  bool ring = false;                                   ///< whether the path is closed
  /// A loop with a fixed point, where it may have a kink. With `ring`: `source` is that point, and find_path() cuts the
  /// first ring open there. Without: an open path whose target is the source again, or an image of it across the seams
  /// of a chart.
  bool based = false;
};

/// Projects a point onto the manifold. `moved` (if given) receives how far it moved. Throws InputError where there is
/// no nearest point.
PathEnd project_end(const ConstraintManifold& manifold, const Eigen::VectorXd& point, double* moved = nullptr);

/// Puts the ends of an open path exactly where the problem has them: the rounding of barycentric coordinates, say, may
/// lift an end above the level of a bead at rest.
void pin_ends(const Problem& problem, CoordinatePath& path);

/// Throws InputError when the parts do not fit (dimensions, missing parts, ends that coincide).
void check(const Problem& problem);

}  // namespace leastcost
