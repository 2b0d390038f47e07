// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/ompl/state_columns.hpp>
#include <leastcost/problems/obstacles/walls.hpp>

namespace leastcost {

/// Walls over poses, whose quaternions are w, x, y, z (`se3`, RobotWalls of a SpatialBody), as walls over the columns
/// of a space, whose quaternions are x, y, z, w as OMPL has them. Without quaternions they are the same walls. Throws
/// InputError for walls of another dimension.
std::shared_ptr<const Walls> make_pose_walls(const StateColumns& states, std::shared_ptr<const Walls> poses);

}  // namespace leastcost
