// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

namespace leastcost {

/// Throws OptionError with this key for an obstacle in the plane where the domain is the Earth, which lies in space:
/// with the ball in space that holds it, where its corners are taken as latitude and longitude.
void refuse_plane_on_earth(const Obstacle& obstacle, const ConstraintManifold& domain, const std::string& key);

}  // namespace leastcost
