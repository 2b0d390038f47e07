// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace leastcost {

/// A segment in space.
struct Segment3 {
  Eigen::Vector3d from, to;

  Eigen::Vector3d at(double t) const { return from + t * (to - from); }
};

/// The least distance of two segments, and where it is: at s on the first and t on the second. Either may be a point.
double distance_of_segments(const Segment3& first, const Segment3& second, double& s, double& t);

}  // namespace leastcost
