// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What a least-cost path is: path, cost, manifold, kernel, energy, solver, certificate, find_path(). What this header
/// reaches is public and installed; everything else in the folder is internal.

#include <leastcost/framework/chain_model.hpp>
#include <leastcost/framework/check_cost.hpp>
#include <leastcost/framework/check_manifold.hpp>
#include <leastcost/framework/family.hpp>
#include <leastcost/framework/find_path.hpp>
#include <leastcost/framework/goes_beyond_bounds.hpp>
#include <leastcost/framework/has_constant_metric.hpp>
#include <leastcost/framework/has_free_places.hpp>
#include <leastcost/framework/has_graph.hpp>
#include <leastcost/framework/has_notes.hpp>
#include <leastcost/framework/other_images.hpp>
#include <leastcost/framework/replanner.hpp>
#include <leastcost/framework/segment_cost_function.hpp>
#include <leastcost/framework/stopping.hpp>
#include <leastcost/framework/waypoints.hpp>
