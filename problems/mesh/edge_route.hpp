// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/mesh/edge_graph.hpp>

namespace leastcost {

/// The least-cost edge path under the problem's own segment cost; A* where the straight line bounds the cost from
/// below. Throws InitializationError where there is none, with the components' sizes or the reason.
EdgePath edge_route(const Problem& problem, const TriangleMesh& mesh, const SurfacePoint& source,
                    const SurfacePoint& target, const Monitor& monitor);

/// The path, where there is one; throws Interrupted where the search was stopped, else InitializationError with the
/// components' sizes, and `reason` behind them.
EdgePath found_or_throw(EdgePath route, const std::string& reason = {});

}  // namespace leastcost
