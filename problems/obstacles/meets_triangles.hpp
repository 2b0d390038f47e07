// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

namespace leastcost {

/// Ability of an obstacle in space: how far triangles are from it is known, so that bodies made of them can meet it.
class MeetsTriangles {
 public:
  virtual ~MeetsTriangles() = default;
  /// The least distance of a point of the triangle from the core, and such a point; 0 where they meet, and where. A
  /// degenerate triangle counts as the segment or point that it is.
  virtual double distance_of_triangle(const std::array<Eigen::Vector3d, 3>& corners,
                                      Eigen::Vector3d& nearest) const = 0;
  /// False in the plane.
  bool present() const { return measures_triangles(); }

 private:
  virtual bool measures_triangles() const { return true; }
};

}  // namespace leastcost
