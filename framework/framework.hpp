// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// What a least-cost path is: path, cost, manifold, kernel, energy, solver, certificate, find_path(). What this header
/// reaches is public and installed; everything else in the folder is internal.

#include <leastcost/framework/certificate/certify.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/has_free_places.hpp>
#include <leastcost/framework/cost/has_notes.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/cost/starts_straight.hpp>
#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/stopping.hpp>
#include <leastcost/framework/family/find_family.hpp>
#include <leastcost/framework/family/same_path.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/framework/replan/replanner.hpp>
#include <leastcost/framework/replan/waypoints.hpp>
#include <leastcost/framework/result/other_images.hpp>
#include <leastcost/framework/result/prove.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/framework/trajectory/trajectory.hpp>
