// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// A bound beside a point: to first order a step from there stays within it where slope . step >= -gap.
struct NearBound {
  static constexpr int kNone = -1;  ///< no bound is near
  int number = kNone;          ///< what retract_onto() calls it; kNone: the retraction stops points there by itself
  Eigen::VectorXd slope = {};  ///< in coordinates
  double gap = 0;              ///< distance to it; negative: beyond it
};

/// Numbers of bounds, for each free point.
using BoundsOfPoints = std::vector<std::vector<int>>;

/// Ability of a domain with bounds: it sees them before a point comes to rest on them, so that one step of a chain may
/// heed all that it would meet.
class SeesBounds {
 public:
  virtual ~SeesBounds() = default;
  /// The bounds that a column lies on, and those that a step by `reach` may meet; some others may be among them.
  virtual void bounds_within(const CoordinatePath& path, Index column, double reach,
                             std::vector<NearBound>& found) const = 0;
  /// As ConstraintManifold::retract, and then each free point comes to rest on these bounds, which its step ends on to
  /// first order, unless it meets another one before.
  virtual void retract_onto(const CoordinatePath& from, const Points& step, const BoundsOfPoints& bounds,
                            CoordinatePath& to) const = 0;
};

}  // namespace leastcost
