// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/graph/sparse_graph.hpp>

#include <algorithm>
#include <map>
#include <random>

#include "problems/graph/shortest_route.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Edge = SparseGraph::Edge;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct WeightedGraph {
  SparseGraph graph;
  std::map<Edge, double> weight;
};

/// A directed graph in which every tenth edge is not passable.
WeightedGraph random_graph(std::mt19937& random, std::int32_t nodes, int edges) {
  std::uniform_int_distribution<std::int32_t> node(0, nodes - 1);
  std::uniform_real_distribution<double> weight(0, 1);
  WeightedGraph out;
  std::vector<Edge> list;
  for (int i = 0; i < edges; ++i) {
    const Edge edge{node(random), node(random)};
    const double w = weight(random);
    if (out.weight.emplace(edge, w < 0.1 ? kInfinity : w).second) list.push_back(edge);
  }
  out.graph = SparseGraph(nodes, list);
  return out;
}

/// Least costs from the source by Bellman and Ford.
std::vector<double> least_costs(const WeightedGraph& g, std::int32_t source) {
  std::vector<double> cost(static_cast<std::size_t>(g.graph.size()), kInfinity);
  cost[static_cast<std::size_t>(source)] = 0;
  for (std::int32_t round = 0; round < g.graph.size(); ++round)
    for (const auto& [edge, w] : g.weight) {
      double& to = cost[static_cast<std::size_t>(edge.second)];
      to = std::min(to, cost[static_cast<std::size_t>(edge.first)] + w);
    }
  return cost;
}

}  // namespace

TEST_CASE("a sparse graph keeps its edges sorted, once each") {
  const SparseGraph graph(4, {{2, 1}, {0, 3}, {2, 0}, {2, 1}, {0, 1}});
  REQUIRE(graph.size() == 4);
  const auto of = [&](std::int32_t node) {
    const auto s = graph.successors(node);
    return std::vector<std::int32_t>(s.begin(), s.end());
  };
  CHECK(of(0) == std::vector<std::int32_t>{1, 3});
  CHECK(of(1).empty());
  CHECK(of(2) == std::vector<std::int32_t>{0, 1});
  CHECK(SparseGraph().size() == 0);
}

TEST_CASE("routes cost what Bellman and Ford say, and are routes of the graph") {
  std::mt19937 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const WeightedGraph g = random_graph(random, 30, 70);
    const std::vector<double> expected = least_costs(g, 0);
    for (const std::int32_t target : {1, 7, 29}) {
      const GraphRoute route = shortest_route(g.graph, {{0}}, {{target}}, [&](std::int32_t from, std::int32_t to) {
        return g.weight.at({from, to});
      });
      const double best = expected[static_cast<std::size_t>(target)];
      REQUIRE((route.outcome == RouteOutcome::found) == (best < kInfinity));
      if (route.outcome != RouteOutcome::found) continue;
      double sum = 0;
      for (std::size_t i = 1; i < route.nodes.size(); ++i) sum += g.weight.at({route.nodes[i - 1], route.nodes[i]});
      CHECK(route.nodes.front() == 0);
      CHECK(route.nodes.back() == target);
      CHECK(sum == Approx(best).epsilon(1e-14));
      CHECK(route.cost == Approx(best).epsilon(1e-14));
    }
  }
}

TEST_CASE("a search ends at its target, and when it is told to") {
  std::vector<Edge> chain;
  for (std::int32_t i = 0; i + 1 < 10000; ++i) chain.emplace_back(i, i + 1);
  const SparseGraph graph(10000, chain);
  const EdgeCost one = [](std::int32_t, std::int32_t) { return 1.0; };
  CHECK(shortest_route(graph, {{0}}, {{10}}, one).settled == 11);
  CHECK(shortest_route(graph, {{5}}, {{5}}, one).nodes == std::vector<std::int32_t>{5});
  CHECK(shortest_route(graph, {{5}}, {{4}}, one).outcome == RouteOutcome::unreachable);
  const GraphRoute stopped = shortest_route(graph, {{0}}, {{9999}}, one, [] { return true; });
  CHECK(stopped.outcome == RouteOutcome::stopped);
  CHECK(stopped.settled < 1000);
  CHECK(stopped.nodes.empty());
}

TEST_CASE("of several starts and ends the cheapest pair is joined, their own costs included") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> cost(0, 3);
  for (int trial = 0; trial < 100; ++trial) {
    const WeightedGraph g = random_graph(random, 30, 70);
    const std::vector<RouteEnd> starts = {{0, cost(random)}, {3, cost(random)}, {11, kInfinity}, {0, cost(random)}};
    const std::vector<RouteEnd> ends = {{20, cost(random)}, {3, 100.0}, {7, cost(random)}};
    double best = kInfinity;
    for (const RouteEnd& start : starts) {
      const std::vector<double> from = least_costs(g, start.node);
      for (const RouteEnd& end : ends)
        best = std::min(best, start.cost + from[static_cast<std::size_t>(end.node)] + end.cost);
    }
    const GraphRoute route = shortest_route(g.graph, starts, ends, [&](std::int32_t from, std::int32_t to) {
      return g.weight.at({from, to});
    });
    REQUIRE(route.outcome == RouteOutcome::found);  // 3 is a start and an end
    CHECK(route.cost == Approx(best).epsilon(1e-14));
    for (std::size_t i = 1; i < route.nodes.size(); ++i)
      CHECK(g.weight.count({route.nodes[i - 1], route.nodes[i]}) == 1);
  }
  CHECK(shortest_route(SparseGraph(2, {{0, 1}}), {}, {{1}}, [](auto, auto) { return 1.0; }).outcome ==
        RouteOutcome::unreachable);
}

TEST_CASE("components are numbered by size") {
  const SparseGraph graph(7, {{1, 2}, {2, 1}, {4, 5}, {5, 4}, {5, 6}, {6, 5}});
  const Components parts = connected_components(graph);
  CHECK(parts.sizes == std::vector<std::int32_t>{3, 2, 1, 1});
  CHECK(parts.of == std::vector<std::int32_t>{2, 1, 1, 3, 0, 0, 0});
}

TEST_CASE("a spanning forest has the least weight") {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> weight(0, 1);
  std::vector<Edge> edges;
  std::vector<double> weights;
  std::map<Edge, double> of;
  for (std::int32_t i = 0; i < 12; ++i)
    for (std::int32_t j = i + 1; j < 12; ++j) {
      edges.emplace_back(i, j);
      weights.push_back(weight(random));
      of[{i, j}] = weights.back();
    }
  double sum = 0;
  const std::vector<Edge> forest = minimum_spanning_forest(13, edges, weights);  // node 12 stands alone
  for (const auto& [a, b] : forest) sum += of.at(std::minmax(a, b));
  REQUIRE(forest.size() == 11);
  // Prim, on the full matrix.
  std::vector<double> nearest(12, kInfinity);
  std::vector<char> in(12, 0);
  nearest[0] = 0;
  double expected = 0;
  for (int step = 0; step < 12; ++step) {
    std::size_t next = 12;
    for (std::size_t i = 0; i < 12; ++i)
      if (in[i] == 0 && (next == 12 || nearest[i] < nearest[next])) next = i;
    in[next] = 1;
    expected += nearest[next];
    for (std::size_t j = 0; j < 12; ++j)
      if (j != next)
        nearest[j] =
            std::min(nearest[j], of.at(std::minmax(static_cast<std::int32_t>(next), static_cast<std::int32_t>(j))));
  }
  CHECK(sum == Approx(expected).epsilon(1e-14));
}

}  // namespace leastcost::test
