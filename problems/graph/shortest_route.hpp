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
  double cost = std::numeric_limits<double>::infinity();  ///< that of the ends included
  std::vector<std::int32_t> nodes;                        ///< from a start to an end; empty unless found
  std::int32_t settled = 0;                               ///< nodes whose least cost became known
};

/// A node where a route may begin or end, and what that costs beside its edges, >= 0; +infinity: it may not.
struct RouteEnd {
  std::int32_t node = 0;
  double cost = 0;
};

/// The least-cost route from one of `starts` to one of `ends` (Dijkstra; searches no farther). An edge is asked for its
/// cost when its tail is settled. `stop` is asked now and then; true: give up.
GraphRoute shortest_route(const SparseGraph& graph, const std::vector<RouteEnd>& starts,
                          const std::vector<RouteEnd>& ends, const EdgeCost& cost,
                          const std::function<bool()>& stop = {});

}  // namespace leastcost
