// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Kernels, costs, manifolds, initializers, post-processors and readers. What this header reaches is public and
/// installed; everything else in the folder is internal.

#include <leastcost/problems/chart/target_images.hpp>
#include <leastcost/problems/costs/clearance_length.hpp>
#include <leastcost/problems/costs/end_effector_length.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/kinetic_energy.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/mirrored.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/angle.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/map.hpp>
#include <leastcost/problems/manifolds/mesh.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/manifolds/point_cloud.hpp>
#include <leastcost/problems/manifolds/pose.hpp>
#include <leastcost/problems/manifolds/product.hpp>
#include <leastcost/problems/manifolds/signed_distance.hpp>
#include <leastcost/problems/mesh/mesh_report.hpp>
#include <leastcost/problems/obstacles/ball.hpp>
#include <leastcost/problems/obstacles/box_obstacle.hpp>
#include <leastcost/problems/obstacles/checker_walls.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/obstacles/mesh_obstacle.hpp>
#include <leastcost/problems/obstacles/polygon.hpp>
#include <leastcost/problems/occupancy/occupancy_options.hpp>
#include <leastcost/problems/post_processors/on_surface.hpp>
#include <leastcost/problems/post_processors/shortest.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>
#include <leastcost/problems/robots/arm_models.hpp>
#include <leastcost/problems/robots/rigid_body.hpp>
#include <leastcost/problems/robots/robot_walls.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
