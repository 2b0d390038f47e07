// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/graph/shortest_route.hpp"

#include <algorithm>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include "problems/graph/compressed_rows.hpp"

namespace leastcost {
namespace {

using Graph = CompressedRows::Graph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kStopInterval = 16;  // settled nodes between two questions to the stop predicate

/// Boost's way to leave a search early is to throw; it ends here.
struct Ended {
  RouteOutcome outcome;
};

struct Search {
  std::vector<RouteEnd> ends;  ///< by node
  const std::function<bool()>& stop;
  std::vector<double> distance;
  std::int32_t settled = 0;
  double best = kInfinity;  ///< of the routes to the ends that are settled
  std::int32_t last = -1;   ///< the end of that route

  RouteOutcome outcome() const { return last < 0 ? RouteOutcome::unreachable : RouteOutcome::found; }

  /// Boost also queues nodes that it could not relax; the first of them means that the rest is out of reach.
  void examine(std::int32_t node) {
    const double here = distance[static_cast<std::size_t>(node)];
    if (!(here < best)) throw Ended{outcome()};
    if (++settled % kStopInterval == 0 && stop && stop()) throw Ended{RouteOutcome::stopped};
    const auto end = std::lower_bound(ends.begin(), ends.end(), node,
                                      [](const RouteEnd& e, std::int32_t wanted) { return e.node < wanted; });
    if (end == ends.end() || end->node != node || !(here + end->cost < best)) return;
    best = here + end->cost;
    last = node;
  }
};

struct Visitor : boost::default_dijkstra_visitor {
  Search* search;
  explicit Visitor(Search* s) : search(s) {}
  void examine_vertex(std::int32_t node, const Graph&) const { search->examine(node); }
};

}  // namespace

GraphRoute shortest_route(const SparseGraph& graph, const std::vector<RouteEnd>& starts,
                          const std::vector<RouteEnd>& ends, const EdgeCost& cost, const std::function<bool()>& stop) {
  const Graph& rows = graph.rows().graph;
  const auto index = get(boost::vertex_index, rows);
  const auto nodes = static_cast<std::size_t>(graph.size());
  Search search{ends, stop, std::vector<double>(nodes, kInfinity)};
  std::sort(search.ends.begin(), search.ends.end(),
            [](const RouteEnd& a, const RouteEnd& b) { return a.node < b.node; });
  std::vector<std::int32_t> predecessor(nodes), open;
  for (const RouteEnd& start : starts) {
    const auto at = static_cast<std::size_t>(start.node);
    if (!(start.cost < search.distance[at])) continue;
    search.distance[at] = start.cost;
    predecessor[at] = start.node;
    open.push_back(start.node);
  }
  const auto weight = [&](const Graph::edge_descriptor& edge) {
    return cost(boost::source(edge, rows), boost::target(edge, rows));
  };
  GraphRoute route;
  try {
    boost::dijkstra_shortest_paths_no_init(
        rows, open.begin(), open.end(), boost::make_iterator_property_map(predecessor.begin(), index),
        boost::make_iterator_property_map(search.distance.begin(), index),
        boost::make_function_property_map<Graph::edge_descriptor, double>(weight), index, std::less<>(),
        boost::closed_plus<double>(kInfinity), 0.0, Visitor{&search});
    route.outcome = search.outcome();
  } catch (const Ended& ended) {
    route.outcome = ended.outcome;
  }
  route.settled = search.settled;
  if (route.outcome != RouteOutcome::found) return route;
  route.cost = search.best;
  route.nodes.assign(1, search.last);
  for (std::int32_t before = -1; before != route.nodes.back();) {
    before = route.nodes.back();
    const std::int32_t next = predecessor[static_cast<std::size_t>(before)];
    if (next != before) route.nodes.push_back(next);
  }
  std::reverse(route.nodes.begin(), route.nodes.end());
  return route;
}

}  // namespace leastcost
