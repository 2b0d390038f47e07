// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/problems/cloud/point_cloud.hpp>
#include <leastcost/problems/distance/distance_source.hpp>

namespace leastcost {

/// Distances from the smooth surface of a point cloud (cloud_surface.hpp). With `sides`, negative against the oriented
/// normals of the samples; a cloud whose sides run into each other (a partial scan, normals that disagree) has none,
/// and sample() throws InputError.
std::shared_ptr<const DistanceSource> make_cloud_distance(PointCloud cloud, bool sides);

}  // namespace leastcost
