// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/graph/sparse_graph.hpp>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <functional>
#include <numeric>

#include "problems/graph/compressed_rows.hpp"

namespace leastcost {
namespace {

std::vector<SparseGraph::Edge> sorted_once(std::vector<SparseGraph::Edge> edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

CompressedRows rows_of(std::int32_t nodes, const std::vector<SparseGraph::Edge>& edges) {
  return {{boost::edges_are_sorted, edges.begin(), edges.end(), nodes}};
}

/// Numbers the sets by size, the largest first.
Components by_size(std::vector<std::int32_t> of, const std::vector<std::int32_t>& sizes) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  Components parts{std::move(of), {}};
  std::vector<std::int32_t> rank(sizes.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    rank[order[k]] = static_cast<std::int32_t>(k);
    parts.sizes.push_back(sizes[order[k]]);
  }
  for (std::int32_t& part : parts.of) part = rank[static_cast<std::size_t>(part)];
  return parts;
}

}  // namespace

SparseGraph::SparseGraph() : SparseGraph(0, {}) {}

SparseGraph::SparseGraph(std::int32_t nodes, std::vector<Edge> edges)
    : rows_(std::make_shared<const CompressedRows>(rows_of(nodes, sorted_once(std::move(edges))))) {}

std::int32_t SparseGraph::size() const { return static_cast<std::int32_t>(boost::num_vertices(rows_->graph)); }

std::span<const std::int32_t> SparseGraph::successors(std::int32_t node) const {
  const auto [begin, end] = boost::adjacent_vertices(node, rows_->graph);
  return {begin, end};
}

Components connected_components(const SparseGraph& graph) {
  std::vector<std::int32_t> of(static_cast<std::size_t>(graph.size()), -1), sizes, open;
  for (std::int32_t start = 0; start < graph.size(); ++start) {
    if (of[static_cast<std::size_t>(start)] >= 0) continue;
    const auto part = static_cast<std::int32_t>(sizes.size());
    sizes.push_back(0);
    open.assign(1, start);
    of[static_cast<std::size_t>(start)] = part;
    while (!open.empty()) {
      const std::int32_t node = open.back();
      open.pop_back();
      ++sizes.back();
      for (const std::int32_t next : graph.successors(node)) {
        std::int32_t& known = of[static_cast<std::size_t>(next)];
        if (known < 0) open.push_back(next);
        known = part;
      }
    }
  }
  return by_size(std::move(of), sizes);
}

std::vector<SparseGraph::Edge> minimum_spanning_forest(std::int32_t nodes, std::span<const SparseGraph::Edge> edges,
                                                       std::span<const double> weights, const Deadline& deadline) {
  using Weighted = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                         boost::property<boost::edge_weight_t, double>>;
  const Weighted graph(edges.begin(), edges.end(), weights.begin(), static_cast<std::size_t>(nodes));
  using Edge = boost::graph_traits<Weighted>::edge_descriptor;
  std::vector<Edge> chosen;
  const std::function<void(const Edge&)> choose = [&](const Edge& edge) {
    look_at_clock(deadline, static_cast<std::int64_t>(chosen.size()));
    chosen.push_back(edge);
  };
  boost::kruskal_minimum_spanning_tree(graph, boost::make_function_output_iterator(choose));
  std::vector<SparseGraph::Edge> forest;
  forest.reserve(chosen.size());
  for (const auto& edge : chosen)
    forest.emplace_back(static_cast<std::int32_t>(boost::source(edge, graph)),
                        static_cast<std::int32_t>(boost::target(edge, graph)));
  return forest;
}

}  // namespace leastcost
