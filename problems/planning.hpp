// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The library leastcost::planning: obstacles, robots and maps.

#include <leastcost/problems/costs/clearance_length.hpp>
#include <leastcost/problems/costs/end_effector_length.hpp>
#include <leastcost/problems/costs/kinetic_energy.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/checker_walls.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/grid_obstacle.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/obstacles/raster_obstacles.hpp>
#include <leastcost/problems/occupancy/occupancy_options.hpp>
#include <leastcost/problems/post_processors/shortest_plan.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/attached.hpp>
#include <leastcost/problems/robots/inverse_kinematics.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_trajectory.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/problems/robots/tree_kinematics.hpp>
#include <leastcost/problems/shapes/box.hpp>
#include <leastcost/problems/shapes/capsule_obstacle.hpp>
#include <leastcost/problems/shapes/cone.hpp>
#include <leastcost/problems/shapes/cylinder.hpp>
#include <leastcost/problems/shapes/half_space.hpp>
#include <leastcost/problems/shapes/height_field.hpp>
#include <leastcost/problems/shapes/point_obstacle.hpp>
