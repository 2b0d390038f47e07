// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>

namespace leastcost {

struct CompressedRows;

/// A directed graph: nodes 0 .. n-1 and, of each, its successors in ascending order. Immutable and cheap to copy.
/// Boost.Graph works behind it (compressed rows), so that no caller sees a second model of a graph.
class SparseGraph {
 public:
  using Edge = std::pair<std::int32_t, std::int32_t>;

  SparseGraph();
  /// Edges in any order; repeated ones count once.
  SparseGraph(std::int32_t nodes, std::vector<Edge> edges);

  std::int32_t size() const;                                          ///< number of nodes
  std::span<const std::int32_t> successors(std::int32_t node) const;  ///< of a node, in ascending order

  const CompressedRows& rows() const { return *rows_; }  ///< successors of all nodes

 private:
  std::shared_ptr<const CompressedRows> rows_;
};

/// The parts of a graph whose edges go both ways.
struct Components {
  std::vector<std::int32_t> of;     ///< the part of each node
  std::vector<std::int32_t> sizes;  ///< nodes of each part, largest first; of equal ones the one with the first node
};
/// The connected parts of an undirected graph.
Components connected_components(const SparseGraph& graph);

/// The edges of a minimum spanning forest of an undirected graph, each once (Kruskal). weights.size() == edges.size().
/// Throws Interrupted.
std::vector<SparseGraph::Edge> minimum_spanning_forest(std::int32_t nodes, std::span<const SparseGraph::Edge> edges,
                                                       std::span<const double> weights, const Deadline& deadline = {});

}  // namespace leastcost
