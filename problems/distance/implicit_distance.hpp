// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/problems/distance/distance_source.hpp>
#include <leastcost/problems/level_set/constraint_function.hpp>

namespace leastcost {

/// Distances from the surface f = 0 in `box` (and where it goes on beyond it), f: R^3 -> R, negative where f is: not f
/// itself, but |x - y| with y the foot of x, by Newton's method on y + lambda grad f(y) = x, f(y) = 0. Throws
/// InputError (in sample()) where f changes its sign without a zero, or has no zero in the grid.
std::shared_ptr<const DistanceSource> make_implicit_distance(std::shared_ptr<const ConstraintFunction> f,
                                                             const Eigen::AlignedBox3d& box);

}  // namespace leastcost
