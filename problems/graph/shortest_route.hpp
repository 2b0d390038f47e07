// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <leastcost/problems/graph/sparse_graph.hpp>

namespace leastcost {

/// Cost of the edge from -> to, >= 0; +infinity: not passable.
using EdgeCost = std::function<double(std::int32_t from, std::int32_t to)>;

enum class RouteOutcome { found, unreachable, stopped };

struct GraphRoute {
  RouteOutcome outcome = RouteOutcome::unreachable;
  double cost = std::numeric_limits<double>::infinity();
  std::vector<std::int32_t> nodes;  ///< source to target; empty unless found
  std::int32_t settled = 0;         ///< nodes whose least cost became known, the source among them
};

/// The least-cost route (Dijkstra; ends at the target). An edge is asked for its cost when its tail is settled. `stop`
/// is asked now and then; true: give up.
GraphRoute shortest_route(const SparseGraph& graph, std::int32_t source, std::int32_t target, const EdgeCost& cost,
                          const std::function<bool()>& stop = {});

}  // namespace leastcost
