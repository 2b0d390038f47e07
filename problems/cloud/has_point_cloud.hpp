// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/problems/cloud/cloud_graph.hpp>
#include <leastcost/problems/cloud/cloud_surface.hpp>
#include <leastcost/problems/cloud/point_cloud.hpp>

namespace leastcost {

/// Ability: the domain is the surface of a point cloud.
class HasPointCloud {
 public:
  virtual ~HasPointCloud() = default;
  virtual const PointCloud& cloud() const = 0;      ///< the samples
  virtual const CloudSurface& surface() const = 0;  ///< the surface through them
  virtual const CloudGraph& graph() const = 0;      ///< edges between neighbours
};

}  // namespace leastcost
