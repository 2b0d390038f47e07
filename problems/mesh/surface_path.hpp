// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// A polyline that lies on a triangle mesh: segment i runs from points[i] to points[i + 1] inside faces[i], so
/// consecutive points share a face, and interior points lie on edges or vertices unless they were asked for.
struct SurfacePath {
  std::vector<Eigen::Vector3d> points;  ///< m + 1 positions
  std::vector<std::int32_t> faces;      ///< m faces
};

}  // namespace leastcost
