// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/domain/sees_bounds.hpp>

namespace leastcost {

/// Calls visit(begin, count) for parts of [0, size), with a look at the clock before each.
template <class Visit>
void in_parts(Index size, Index length, const Deadline& deadline, Visit visit) {
  for (Index begin = 0; begin < size; begin += length) {
    look_at_clock(deadline);
    visit(begin, std::min(length, size - begin));
  }
}

/// What a manifold does to all columns of a path, part by part where there is a deadline; the numbers are the same. All
/// throw Interrupted.
Projection project(const ConstraintManifold& manifold, CoordinatePath& path, const Deadline& deadline);
void tangent_bases(const ConstraintManifold& manifold, const CoordinatePath& path, Points& bases,
                   const Deadline& deadline);
double residual(const ConstraintManifold& manifold, const CoordinatePath& path, const Deadline& deadline);
/// `beyond`: without the bounds, see GoesBeyondBounds; the domain must have that ability.
void retract(const ConstraintManifold& manifold, const CoordinatePath& from, const Points& step, CoordinatePath& to,
             const Deadline& deadline, bool beyond = false);
void retract_onto(const SeesBounds& domain, const CoordinatePath& from, const Points& step,
                  const BoundsOfPoints& bounds, CoordinatePath& to, const Deadline& deadline);
void embed(const HasChart& chart, const CoordinatePath& path, Points& x, const Deadline& deadline);
void jacobians(const HasChart& chart, const CoordinatePath& path, Points& j, const Deadline& deadline);
void embed_with_jacobians(const HasChart& chart, const CoordinatePath& path, Points& x, Points& j,
                          const Deadline& deadline);
void curvatures(const HasChart& chart, const CoordinatePath& path, const Points& weights, Points& h,
                const Deadline& deadline);

}  // namespace leastcost
