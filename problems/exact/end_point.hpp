// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "problems/exact/half_edges.hpp"
#include "problems/mesh/surface_walk.hpp"

namespace leastcost {

/// An end of a query: a vertex, or a point with the faces it lies on.
struct EndPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::int32_t vertex = -1;         ///< or -1
  std::int32_t edge = -1;           ///< a half-edge of the edge it is inside of, or -1
  std::vector<std::int32_t> faces;  ///< that it lies on; empty for a vertex
  double error = 0;                 ///< how far `position` may be from the point that was meant, length units
};

EndPoint end_point(const HalfEdges& mesh, const SurfacePoint& p);

}  // namespace leastcost
