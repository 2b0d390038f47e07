// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>

namespace leastcost {

/// Flips normals so that neighbours agree, along the minimum spanning tree of the edges under the weight 1 - |n_a .
/// n_b| (Hoppe et al. 1992). In every connected part the normal of the point that is highest along z looks
/// upwards, which is outwards on a closed surface. On a one-sided surface some neighbours stay opposed.
void orient_normals(const std::vector<Eigen::Vector3d>& positions,
                    const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
                    std::vector<Eigen::Vector3d>& normals, const Deadline& deadline = {});

}  // namespace leastcost
