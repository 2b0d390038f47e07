// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// The library leastcost::mesh: triangle meshes, point clouds and distance grids.

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/exact/landmark_file.hpp>
#include <leastcost/problems/fields/descent.hpp>
#include <leastcost/problems/fields/fast_marching.hpp>
#include <leastcost/problems/fields/heat.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>
#include <leastcost/problems/mesh/mesh_report.hpp>
#include <leastcost/problems/post_processors/shortest.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
