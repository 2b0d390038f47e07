// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cloud/orient_normals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <leastcost/problems/graph/sparse_graph.hpp>

namespace leastcost {
namespace {

using TreeLinks = std::vector<std::vector<std::int32_t>>;

TreeLinks spanning_tree(const std::vector<SparseGraph::Edge>& edges, const std::vector<Eigen::Vector3d>& normals,
                        const Deadline& deadline) {
  std::vector<double> weights;
  weights.reserve(edges.size());
  for (const auto& [a, b] : edges)
    weights.push_back(1 - std::abs(normals[static_cast<std::size_t>(a)].dot(normals[static_cast<std::size_t>(b)])));
  TreeLinks links(normals.size());
  for (const auto& [a, b] :
       minimum_spanning_forest(static_cast<std::int32_t>(normals.size()), edges, weights, deadline)) {
    links[static_cast<std::size_t>(a)].push_back(b);
    links[static_cast<std::size_t>(b)].push_back(a);
  }
  return links;
}

}  // namespace

void orient_normals(const std::vector<Eigen::Vector3d>& positions,
                    const std::vector<std::pair<std::int32_t, std::int32_t>>& edges,
                    std::vector<Eigen::Vector3d>& normals, const Deadline& deadline) {
  const TreeLinks links = spanning_tree(edges, normals, deadline);
  std::vector<std::int32_t> by_height(positions.size()), open;
  std::iota(by_height.begin(), by_height.end(), 0);
  std::stable_sort(by_height.begin(), by_height.end(), [&](std::int32_t a, std::int32_t b) {
    return positions[static_cast<std::size_t>(a)].z() > positions[static_cast<std::size_t>(b)].z();
  });
  std::vector<char> done(positions.size(), 0);
  for (const std::int32_t highest : by_height) {
    const auto top = static_cast<std::size_t>(highest);
    if (done[top] != 0) continue;
    done[top] = 1;
    if (normals[top].z() < 0) normals[top] = -normals[top];
    open.assign(1, highest);
    while (!open.empty()) {
      const auto from = static_cast<std::size_t>(open.back());
      open.pop_back();
      for (const std::int32_t next : links[from]) {
        const auto to = static_cast<std::size_t>(next);
        if (done[to] != 0) continue;
        done[to] = 1;
        if (normals[from].dot(normals[to]) < 0) normals[to] = -normals[to];
        open.push_back(next);
      }
    }
  }
}

}  // namespace leastcost
