// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The library leastcost::core: what needs no mesh, no obstacles and no bounds. The plane and space, surfaces given by
/// formulas, terrain; costs, first paths and post-processors for them.

#include <leastcost/problems/chart/target_images.hpp>
#include <leastcost/problems/costs/combined_cost.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/formula_cost.hpp>
#include <leastcost/problems/costs/layers.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/fields/cost_field.hpp>
#include <leastcost/problems/fields/space_field.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/cell_graph.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/mirrored.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/angle.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include <leastcost/problems/manifolds/earth.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/manifolds/pose.hpp>
#include <leastcost/problems/manifolds/product.hpp>
#include <leastcost/problems/post_processors/cell_bound.hpp>
#include <leastcost/problems/post_processors/choose_global_proof.hpp>
#include <leastcost/problems/post_processors/fastest_refraction.hpp>
#include <leastcost/problems/post_processors/on_surface.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include <leastcost/problems/post_processors/switchbacks.hpp>
