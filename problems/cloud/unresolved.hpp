// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

#include <leastcost/problems/cloud/cloud_graph.hpp>
#include <leastcost/problems/cloud/cloud_surface.hpp>

namespace leastcost {

/// Why the surface of a cloud is none near x (in the coordinates of the file), with the place:
/// CloudSurface::other_sheet in words. Empty where nothing is known against it.
std::string why_unresolved_at(const CloudSurface& surface, const Eigen::Vector3d& x);

/// Why the surface of a cloud has no point near x (in the coordinates of the file), though it has samples or a place
/// near it: a hole or a border, two sheets, noise; and which `radius` has one, found by trying wider ones on the
/// samples around x.
std::string why_no_surface_at(const PointCloud& cloud, const CloudSurface& surface, const Eigen::Vector3d& x);

/// What parts two parts of a cloud, and what joins them: the place and the width of the gap, with the `max_edge` that
/// spans it and the `radius` whose surface does, found by trying; or that none does.
std::string how_to_join(const PointCloud& cloud, const CloudGraph& graph, std::int32_t part, std::int32_t other);

}  // namespace leastcost
