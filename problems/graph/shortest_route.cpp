// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/graph/shortest_route.hpp"

#include <algorithm>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include "problems/graph/compressed_rows.hpp"

namespace leastcost {
namespace {

using Graph = SparseGraph::Rows::Graph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kStopInterval = 16;  // settled nodes between two questions to the stop predicate

/// Boost's way to leave a search early is to throw; it ends here.
struct Ended {
  RouteOutcome outcome;
};

struct Search {
  const std::int32_t target;
  const std::function<bool()>& stop;
  std::vector<double> distance;
  std::int32_t settled = 0;

  /// Boost also queues nodes that it could not relax; the first of them means that the rest is out of reach.
  void examine(std::int32_t node) {
    if (!(distance[static_cast<std::size_t>(node)] < kInfinity)) throw Ended{RouteOutcome::unreachable};
    if (node == target) throw Ended{RouteOutcome::found};
    if (++settled % kStopInterval == 0 && stop && stop()) throw Ended{RouteOutcome::stopped};
  }
};

struct Visitor : boost::default_dijkstra_visitor {
  Search* search;
  explicit Visitor(Search* s) : search(s) {}
  void examine_vertex(std::int32_t node, const Graph&) const { search->examine(node); }
};

}  // namespace

GraphRoute shortest_route(const SparseGraph& graph, std::int32_t source, std::int32_t target, const EdgeCost& cost,
                          const std::function<bool()>& stop) {
  const Graph& rows = graph.rows().graph;
  const auto index = get(boost::vertex_index, rows);
  const auto nodes = static_cast<std::size_t>(graph.size());
  std::vector<std::int32_t> predecessor(nodes);
  Search search{target, stop, std::vector<double>(nodes, kInfinity)};
  const auto weight = [&](const Graph::edge_descriptor& edge) {
    return cost(boost::source(edge, rows), boost::target(edge, rows));
  };
  GraphRoute route;
  try {
    boost::dijkstra_shortest_paths(
        rows, source,
        boost::visitor(Visitor{&search})
            .predecessor_map(boost::make_iterator_property_map(predecessor.begin(), index))
            .distance_map(boost::make_iterator_property_map(search.distance.begin(), index))
            .distance_inf(kInfinity)
            .weight_map(boost::make_function_property_map<Graph::edge_descriptor, double>(weight)));
  } catch (const Ended& ended) {
    route.outcome = ended.outcome;
  }
  route.settled = search.settled;
  if (route.outcome != RouteOutcome::found) return route;
  route.cost = search.distance[static_cast<std::size_t>(target)];
  route.nodes.assign(1, target);
  while (route.nodes.back() != source) route.nodes.push_back(predecessor[static_cast<std::size_t>(route.nodes.back())]);
  std::reverse(route.nodes.begin(), route.nodes.end());
  return route;
}

}  // namespace leastcost
