// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace leastcost {

struct Triangulation {
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< corner numbers of the polygon, in its orientation
  bool simple = true;                                  ///< false: it was found to cross itself
};

/// Cuts a polygon with m >= 3 corners into m - 2 triangles without new vertices: convex ones into the fan of corner 0,
/// other quads along the diagonal that lies inside, everything else by clipping ears in the plane of the polygon's area
/// vector. O(m) for convex, O(m^2) for other polygons. Throws InputError on a non-convex polygon with more than 20000
/// corners.
Triangulation triangulate_polygon(std::span<const Eigen::Vector3d> corners);

}  // namespace leastcost
