// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/obstacles/obstacle_walls.hpp>

namespace leastcost {

/// The walls of obstacles in the space that a domain lies in; among poses of a body (HasOrigin), in the space that its
/// origin is in. Throws as ObstacleWalls.
std::shared_ptr<const Walls> walls_in(const ConstraintManifold& domain, ObstacleWalls::Obstacles obstacles,
                                      double clearance);

}  // namespace leastcost
