// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/gathered_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace leastcost {
namespace {

/// Measured on stars of 4 to 300 faces: a window goes round a vertex without end where its root is within 80 roundings
/// of the lengths of the vertex's edges together. Each edge between two faces is counted twice here.
constexpr double kAtOnePlace = 64 * std::numeric_limits<double>::epsilon();
/// Of the longest edge: no edge as long as this is within rounding of the edges at its ends.
constexpr double kSurelyApart = 1e-9;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

double edge_length(const TriangleMesh& mesh, std::int32_t h) {
  return (mesh.position(mesh.head(h)) - mesh.position(mesh.tail(h))).norm();
}

/// Some edge may be within rounding.
bool has_short_edge(const TriangleMesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const double length = edge_length(mesh, h);
    if (length > 0) shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  return shortest <= kSurelyApart * longest;
}

/// Of every vertex the least one that edges within rounding lead to.
std::vector<std::int32_t> firsts(const TriangleMesh& mesh) {
  std::vector<double> lengths(at(mesh.vertex_count()), 0.0);  // of the edges at each vertex
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const double length = edge_length(mesh, h);
    for (const std::int32_t v : {mesh.tail(h), mesh.head(h)}) lengths[at(v)] += length;
  }
  std::vector<std::int32_t> next(at(mesh.vertex_count()));
  std::iota(next.begin(), next.end(), 0);
  const auto first_of = [&next](std::int32_t v) {
    while (next[at(v)] != v) v = next[at(v)] = next[at(next[at(v)])];
    return v;
  };
  for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const std::int32_t tail = mesh.tail(h), head = mesh.head(h);
    if (!(edge_length(mesh, h) <= kAtOnePlace * (lengths[at(tail)] + lengths[at(head)]))) continue;
    const std::int32_t one = first_of(tail), other = first_of(head);
    next[at(std::max(one, other))] = std::min(one, other);
  }
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) next[at(v)] = first_of(v);
  return next;
}

}  // namespace

std::optional<GatheredMesh> GatheredMesh::of(const TriangleMesh& mesh) {
  constexpr double kUp = 1 + 1e-9;  // for the rounding of the sum
  if (!has_short_edge(mesh)) return std::nullopt;
  const std::vector<std::int32_t> first = firsts(mesh);
  PolygonSoup soup;
  soup.source = mesh.source();
  soup.positions.reserve(first.size());
  double error = 0;
  for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Vector3d& to = mesh.position(first[at(v)]);
    error += kUp * (to - mesh.position(v)).norm() * static_cast<double>(mesh.faces_of_vertex(v).size());
    soup.positions.push_back(to);
  }
  if (!(error > 0)) return std::nullopt;
  soup.corners.reserve(3 * mesh.faces().size());
  soup.polygon_begin.reserve(mesh.faces().size() + 1);
  soup.polygon_begin.assign(1, 0);
  for (const auto& face : mesh.faces()) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.polygon_begin.push_back(static_cast<std::int32_t>(soup.corners.size()));
  }
  return GatheredMesh(TriangleMesh(soup), error);
}

GatheredMesh::GatheredMesh(TriangleMesh mesh, double error) : mesh_(std::move(mesh)), error_(error) {}

SurfacePath GatheredMesh::back(SurfacePath path, const Eigen::Vector3d& source, const Eigen::Vector3d& target,
                               std::int32_t face) const {
  if (path.points.empty()) return path;
  if (path.faces.empty() && source != target) return {{source, target}, {face}};
  path.points.front() = source;
  path.points.back() = target;
  return path;
}

}  // namespace leastcost
