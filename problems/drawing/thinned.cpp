// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Vertex clustering: all vertices in a cell of a grid become one (Rossignac, Borrel 1993).
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include "problems/drawing/thinned.hpp"

namespace leastcost {
namespace {

using Key = std::uint64_t;

Key cell_of(const Eigen::Vector3d& x, const Eigen::Vector3d& origin, double cell, int di = 0, int dj = 0, int dk = 0) {
  const auto at = [&](Index i, int d) {
    return static_cast<Key>(static_cast<std::int64_t>(std::floor((x[i] - origin[i]) / cell)) + d + 16) & 0x1fffff;
  };
  return at(0, di) << 42 | at(1, dj) << 21 | at(2, dk);
}

/// The cells in which vertices keep to themselves: those of the focus and their neighbours.
std::unordered_set<Key> cells_kept(const Points& focus, const Eigen::Vector3d& origin, double cell) {
  std::unordered_set<Key> kept;
  for (Index c = 0; c < focus.cols(); ++c)
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) kept.insert(cell_of(focus.col(c), origin, cell, i, j, k));
  return kept;
}

TriangleSoup clustered(const TriangleSoup& mesh, const Points& focus, const Eigen::Vector3d& origin, double cell) {
  const std::unordered_set<Key> kept = cells_kept(focus, origin, cell);
  TriangleSoup out;
  std::unordered_map<Key, int> cluster_of_cell;
  std::vector<int> cluster(mesh.vertices.size()), size;
  for (std::size_t v = 0; v < cluster.size(); ++v) {
    const Eigen::Vector3d& x = mesh.vertices[v];
    const Key key = cell_of(x, origin, cell);
    const int next = static_cast<int>(out.vertices.size());
    cluster[v] = kept.count(key) > 0 ? next : cluster_of_cell.emplace(key, next).first->second;
    if (cluster[v] == next) {
      out.vertices.emplace_back(0, 0, 0);
      size.push_back(0);
    }
    out.vertices[static_cast<std::size_t>(cluster[v])] += x;
    ++size[static_cast<std::size_t>(cluster[v])];
  }
  for (std::size_t c = 0; c < size.size(); ++c) out.vertices[c] /= size[c];
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<int, 3> t = {cluster[static_cast<std::size_t>(a)], cluster[static_cast<std::size_t>(b)],
                                  cluster[static_cast<std::size_t>(c)]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.triangles.push_back(t);
  }
  return out;
}

double area(const TriangleSoup& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& x = mesh.vertices[static_cast<std::size_t>(a)];
    twice +=
        (mesh.vertices[static_cast<std::size_t>(b)] - x).cross(mesh.vertices[static_cast<std::size_t>(c)] - x).norm();
  }
  return twice / 2;
}

}  // namespace

TriangleSoup thinned(TriangleSoup mesh, const Points& focus, std::size_t budget) {
  if (mesh.triangles.size() <= budget || mesh.vertices.empty()) return mesh;
  Eigen::Vector3d lower = mesh.vertices.front(), upper = lower;
  for (const Eigen::Vector3d& x : mesh.vertices) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  // About 1.4 cells of a grid hold a square of surface of their size, and there are two triangles per vertex.
  double cell = std::sqrt(2.8 * area(mesh) / static_cast<double>(budget));
  cell = std::max(cell, (upper - lower).norm() / 1e6);  // 2^21 cells along an axis
  for (int attempt = 0; attempt < 12; ++attempt, cell *= 1.3) {
    TriangleSoup out = clustered(mesh, focus, lower, cell);
    if (out.triangles.size() <= budget) return out;
  }
  return mesh;
}

}  // namespace leastcost
