// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// Ability of a curved domain with bounds: it goes on beyond them. Second differences of the retraction, which give the
/// curvature (PathEnergy::chain_hessian), must not see a point be stopped by a bound on one side only.
class GoesBeyondBounds : public HasBounds {
 public:
  /// As ConstraintManifold::retract, without bounds but for those that a point of `from` lies on and its step runs
  /// along: these hold it.
  virtual void retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const = 0;
};

}  // namespace leastcost
