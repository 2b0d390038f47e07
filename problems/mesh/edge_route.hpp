// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/monitor.hpp>
#include <leastcost/framework/problem.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>

namespace leastcost {

/// The least-cost edge path under the problem's own segment cost; A* where the straight line bounds the cost from
/// below. Throws InitializationError where there is none, with the components' sizes or the reason.
EdgePath edge_route(const Problem& problem, const TriangleMesh& mesh, EdgeGraphSearch& search,
                    const SurfacePoint& source, const SurfacePoint& target, const Monitor& monitor);

}  // namespace leastcost
