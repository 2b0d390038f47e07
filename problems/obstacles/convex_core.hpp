// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/obstacles/meets_triangles.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// A bounded convex core in a frame of its own: what PosedObstacle can turn and move.
class ConvexCore : public Obstacle, public MeetsTriangles {
 public:
  bool convex() const final { return true; }
  /// The largest scalar product of a direction with a point of the core.
  virtual double support(const Vector& direction) const = 0;
};

}  // namespace leastcost
