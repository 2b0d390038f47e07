// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// A convex core in space that knows its nearest point to a place. Distances of segments and triangles, for which there
/// is no closed form, are found from the planes that it lies behind there: convex functions, bounded from below by
/// their tangents. They are nowhere more than the true distance, and less by some 1e-14 of the lengths.
class RoundCore : public Obstacle, public MeetsTriangles {
 public:
  Box core_bounds() const final;
  double radius() const final { return 0; }
  bool convex() const final { return true; }
  double distance(const Vector& x, Eigen::Ref<Vector> away) const final;
  double distance_of_segment(const Vector& a, const Vector& b, double& t) const final;
  double distance_of_triangle(const std::array<Eigen::Vector3d, 3>& corners, Eigen::Vector3d& nearest) const final;

 protected:
  /// The largest scalar product of a direction with a point of the core.
  virtual double reach(const Eigen::Vector3d& direction) const = 0;

 private:
  /// Distance, negative within, and the way out of length one: the core lies behind the plane across it.
  virtual double distance_of(const Eigen::Vector3d& x, Eigen::Vector3d& normal) const = 0;
};

}  // namespace leastcost
