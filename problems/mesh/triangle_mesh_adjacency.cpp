// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The tables of TriangleMesh that follow from its triangles: adjacency, vertex tables, normals, components.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/mesh/edge_table.hpp"

namespace leastcost {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Counts to starts: entry i becomes the sum of all entries before it.
void accumulate_starts(std::vector<std::int32_t>& counts) {
  std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), 0);
}

}  // namespace

void TriangleMesh::build_adjacency(const Deadline& deadline) {
  const EdgeTable edges = make_edge_table(faces_, vertex_count(), deadline);
  across_.assign(3 * faces_.size(), kBorder);
  on_border_.assign(positions_.size(), 0);
  neighbour_begin_.assign(positions_.size() + 1, 0);
  for (std::int32_t e = 0; e < edges.size(); ++e) {
    look_at_clock(deadline, e);
    const auto& [a, b] = edges.ends[at(e)];
    ++neighbour_begin_[at(a)];
    ++neighbour_begin_[at(b)];
    const std::span<const std::int32_t> sides = edges.of(e);
    if (sides.size() == 1) {
      on_border_[at(a)] = on_border_[at(b)] = 1;
    } else if (sides.size() == 2) {
      across_[at(sides[0])] = sides[1];
      across_[at(sides[1])] = sides[0];
    } else {
      for (const std::int32_t h : sides) across_[at(h)] = kNonManifold;
      non_manifold_edges_.emplace_back(a, b);
    }
  }
  for (std::int32_t h = 0; h < 3 * face_count(); ++h) {
    if (across(h) >= 0 && tail(h) == tail(across(h))) flipped_halfedges_.push_back(h);
  }
  look_at_clock(deadline);
  accumulate_starts(neighbour_begin_);
  neighbours_.resize(2 * edges.ends.size());
  std::vector<std::int32_t> fill(neighbour_begin_.begin(), neighbour_begin_.end() - 1);
  // Edges ascend by their lower end, then the higher one, so each list comes out ascending.
  for (const auto& [a, b] : edges.ends) {
    neighbours_[at(fill[at(a)]++)] = b;
    neighbours_[at(fill[at(b)]++)] = a;
  }
}

std::vector<double> TriangleMesh::corner_angles(const Deadline& deadline) const {
  std::vector<double> angles(3 * faces_.size());
  for (std::int32_t h = 0; h < 3 * face_count(); ++h) {
    look_at_clock(deadline, h);
    const Eigen::Vector3d a = position(head(h)) - position(tail(h));
    const Eigen::Vector3d b = position(tail(previous(h))) - position(tail(h));
    angles[at(h)] = std::atan2(a.cross(b).norm(), a.dot(b));
  }
  return angles;
}

void TriangleMesh::build_vertex_tables(std::span<const double> angles, const Deadline& deadline) {
  vertex_face_begin_.assign(positions_.size() + 1, 0);
  for (const auto& corners : faces_) {
    for (const std::int32_t v : corners) ++vertex_face_begin_[at(v)];
  }
  look_at_clock(deadline);
  accumulate_starts(vertex_face_begin_);
  vertex_faces_.resize(3 * faces_.size());
  std::vector<std::int32_t> fill(vertex_face_begin_.begin(), vertex_face_begin_.end() - 1);
  for (std::int32_t f = 0; f < face_count(); ++f) {
    for (const std::int32_t v : face(f)) vertex_faces_[at(fill[at(v)]++)] = f;
  }
  look_at_clock(deadline);
  vertex_angle_.assign(positions_.size(), 0.0);
  for (std::int32_t h = 0; h < 3 * face_count(); ++h) vertex_angle_[at(tail(h))] += angles[at(h)];
}

void TriangleMesh::build_normals(std::span<const double> angles, const Deadline& deadline) {
  std::vector<Eigen::Vector3d> normals;
  normals.reserve(faces_.size());
  for (std::int32_t f = 0; f < face_count(); ++f) {
    look_at_clock(deadline, f);
    normals.push_back(face_normal(f));
  }
  fan_normals_.reserve(positions_.size());  // more only where sheets meet
  corner_fan_.assign(3 * faces_.size(), -1);
  for (std::int32_t h = 0; h < 3 * face_count(); ++h) {
    look_at_clock(deadline, h);
    if (corner_fan_[at(h)] >= 0) continue;
    fan_normals_.push_back(fan_normal(h, static_cast<std::int32_t>(fan_normals_.size()), angles, normals));
  }
}

/// Walks from face to face around the tail of halfedge `corner`, both ways until a border, a non-manifold edge or the
/// start, marks every corner met with the fan and whether its face is flipped against the first one, and adds up.
Eigen::Vector3d TriangleMesh::fan_normal(std::int32_t corner, std::int32_t fan, std::span<const double> angles,
                                         std::span<const Eigen::Vector3d> normals) {
  const auto weighted = [&](std::int32_t h) { return Eigen::Vector3d(angles[at(h)] * normals[at(h / 3)]); };
  const std::int32_t v = tail(corner);
  corner_fan_[at(corner)] = 2 * fan;
  Eigen::Vector3d sum = weighted(corner);
  for (std::int32_t side : {corner, previous(corner)}) {
    std::int32_t flipped = 0;
    for (std::int32_t other = across(side); other >= 0; other = across(side)) {
      flipped ^= tail(other) == tail(side) ? 1 : 0;
      const std::int32_t met = tail(other) == v ? other : next(other);
      if (corner_fan_[at(met)] >= 0) break;
      corner_fan_[at(met)] = 2 * fan + flipped;
      sum += (flipped == 0 ? 1.0 : -1.0) * weighted(met);
      side = met == other ? previous(met) : met;  // leave by the other edge at v
    }
  }
  const double norm = sum.norm();
  return norm > 0 ? Eigen::Vector3d(sum / norm) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

void TriangleMesh::build_components() {
  component_.assign(positions_.size(), -1);
  std::vector<std::int32_t> stack;
  for (std::int32_t seed = 0; seed < vertex_count(); ++seed) {
    if (component_[at(seed)] >= 0) continue;
    const std::int32_t id = static_cast<std::int32_t>(component_sizes_.size());
    component_sizes_.push_back(0);
    component_[at(seed)] = id;
    stack.push_back(seed);
    while (!stack.empty()) {
      const std::int32_t v = stack.back();
      stack.pop_back();
      ++component_sizes_.back();
      for (const std::int32_t w : neighbours(v)) {
        if (component_[at(w)] >= 0) continue;
        component_[at(w)] = id;
        stack.push_back(w);
      }
    }
  }
}

}  // namespace leastcost
