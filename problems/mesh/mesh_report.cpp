// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/mesh_report.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "problems/mesh/edge_table.hpp"
#include "problems/mesh/weld.hpp"

namespace leastcost {
namespace {

std::size_t index_of(std::int32_t i) { return static_cast<std::size_t>(i); }

template <class Item>
void count_and_name(std::int32_t& count, std::vector<Item>& named, const Item& item) {
  ++count;
  if (named.size() < MeshReport::kNamed) named.push_back(item);
}

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    for (; parent_[i] != i; i = parent_[i]) parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[std::max(find(i), find(j))] = std::min(find(i), find(j)); }

 private:
  std::vector<std::size_t> parent_;
};

class Inspector {
 public:
  explicit Inspector(const TriangleMesh& mesh)
      : mesh_(mesh), edges_(make_edge_table(mesh.faces(), mesh.vertex_count())) {
    report_.components.resize(mesh.component_sizes().size());
  }

  MeshReport run() {
    count_elements();
    inspect_edges();
    inspect_boundary();
    inspect_vertices();
    inspect_orientation();
    inspect_faces();
    find_duplicate_faces();
    find_duplicate_positions();
    find_near_positions();
    conclude();
    return std::move(report_);
  }

 private:
  MeshReport::Component& component_of_face(std::int32_t f) {
    return report_.components[index_of(mesh_.component(mesh_.face(f)[0]))];
  }
  MeshReport::Component& component_of_vertex(std::int32_t v) {
    return report_.components[index_of(mesh_.component(v))];
  }

  void count_elements() {
    report_.vertices = mesh_.vertex_count();
    report_.edges = edges_.size();
    report_.faces = mesh_.face_count();
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) ++component_of_vertex(v).vertices;
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) ++component_of_face(f).faces;
    // What welding merged is in a face, so -1 means just this.
    for (std::int32_t v = 0; v < mesh_.file_vertex_count(); ++v)
      report_.unreferenced_vertices += mesh_.vertex_of_file(v) < 0 ? 1 : 0;
  }

  void inspect_edges() {
    report_.min_edge = std::numeric_limits<double>::infinity();
    for (std::int32_t e = 0; e < edges_.size(); ++e) {
      const auto& [a, b] = edges_.ends[index_of(e)];
      const std::array<std::int32_t, 2> name = {mesh_.file_vertex(a), mesh_.file_vertex(b)};
      const double length = (mesh_.position(a) - mesh_.position(b)).norm();
      report_.min_edge = std::min(report_.min_edge, length);
      report_.max_edge = std::max(report_.max_edge, length);
      ++component_of_vertex(a).edges;
      const std::span<const std::int32_t> sides = edges_.of(e);
      if (sides.size() == 1) {
        ++report_.border_edges;
        ++component_of_vertex(a).border_edges;
      } else if (sides.size() > 2) {
        count_and_name(report_.non_manifold_edges, report_.named_non_manifold_edges, name);
        component_of_vertex(a).manifold = false;
      } else if (mesh_.tail(sides[0]) == mesh_.tail(sides[1])) {
        count_and_name(report_.flipped_edges, report_.named_flipped_edges, name);
      }
    }
  }

  void inspect_boundary() {
    DisjointSets loops(mesh_.positions().size());
    for (std::int32_t e = 0; e < edges_.size(); ++e) {
      if (edges_.of(e).size() == 1)
        loops.join(index_of(edges_.ends[index_of(e)][0]), index_of(edges_.ends[index_of(e)][1]));
    }
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (!mesh_.on_border(v) || loops.find(index_of(v)) != index_of(v)) continue;
      ++report_.boundary_loops;
      ++component_of_vertex(v).boundary_loops;
    }
  }

  /// The faces around a vertex make a graph on its neighbours; it must be connected.
  void inspect_vertices() {
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      const std::span<const std::int32_t> around = mesh_.neighbours(v);
      DisjointSets link(around.size());
      std::size_t parts = around.size();
      for (const std::int32_t f : mesh_.faces_of_vertex(v)) {
        std::array<std::size_t, 2> ends{};
        std::size_t found = 0;
        for (const std::int32_t w : mesh_.face(f)) {
          if (w != v)
            ends[found++] =
                static_cast<std::size_t>(std::lower_bound(around.begin(), around.end(), w) - around.begin());
        }
        if (link.find(ends[0]) != link.find(ends[1])) --parts;
        link.join(ends[0], ends[1]);
      }
      if (parts == 1) continue;
      count_and_name(report_.non_manifold_vertices, report_.named_non_manifold_vertices, mesh_.file_vertex(v));
      component_of_vertex(v).manifold = false;
    }
  }

  /// Turns faces one after the other to agree with a neighbour; a disagreement that remains has no remedy.
  void inspect_orientation() {
    std::vector<signed char> turned(index_of(mesh_.face_count()), -1);
    std::vector<std::int32_t> stack;
    for (std::int32_t seed = 0; seed < mesh_.face_count(); ++seed) {
      if (turned[index_of(seed)] >= 0) continue;
      turned[index_of(seed)] = 0;
      stack.push_back(seed);
      while (!stack.empty()) {
        const std::int32_t f = stack.back();
        stack.pop_back();
        for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h) {
          const std::int32_t other = mesh_.across(h);
          if (other < 0) continue;
          const bool same_direction = mesh_.tail(other) == mesh_.tail(h);
          const signed char wanted =
              static_cast<signed char>(same_direction ? 1 - turned[index_of(f)] : turned[index_of(f)]);
          signed char& there = turned[index_of(other / 3)];
          if (there < 0) {
            there = wanted;
            stack.push_back(other / 3);
          } else if (there != wanted) {
            component_of_face(f).orientable = false;
          }
        }
      }
    }
  }

  void inspect_faces() {
    report_.min_angle = std::numeric_limits<double>::infinity();
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      const auto& corners = mesh_.face(f);
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d a = mesh_.position(corners[(k + 1) % 3]) - mesh_.position(corners[k]);
        const Eigen::Vector3d b = mesh_.position(corners[(k + 2) % 3]) - mesh_.position(corners[k]);
        const double twice_area = a.cross(b).norm();
        report_.min_angle = std::min(report_.min_angle, std::atan2(twice_area, a.dot(b)));
        if (k == 0) report_.area += 0.5 * twice_area;
      }
      if (mesh_.face_normal(f).isZero(0)) {
        count_and_name(report_.degenerate_faces, report_.named_degenerate_faces, mesh_.file_face(f));
      }
    }
  }

  void find_duplicate_faces() {
    std::vector<std::pair<std::array<std::int32_t, 3>, std::int32_t>> sorted;
    sorted.reserve(mesh_.faces().size());
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      std::array<std::int32_t, 3> corners = mesh_.face(f);
      std::sort(corners.begin(), corners.end());
      sorted.emplace_back(corners, f);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::int32_t> duplicates;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
      if (sorted[i].first == sorted[i - 1].first) duplicates.push_back(sorted[i].second);
    }
    std::sort(duplicates.begin(), duplicates.end());
    for (const std::int32_t f : duplicates) {
      count_and_name(report_.duplicate_faces, report_.named_duplicate_faces, mesh_.file_face(f));
    }
  }

  void find_duplicate_positions() {
    const std::vector<std::int32_t> same_as = lowest_equal(mesh_.positions());
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (same_as[index_of(v)] != v)
        count_and_name(report_.duplicate_positions, report_.named_duplicate_positions, mesh_.file_vertex(v));
    }
  }

  /// Seams that rounding has opened: both sides are borders.
  void find_near_positions() {
    constexpr double kNear = 1e-5;  // diagonals
    std::vector<std::int32_t> border;
    std::vector<Eigen::Vector3d> positions;
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (!mesh_.on_border(v)) continue;
      border.push_back(v);
      positions.push_back(mesh_.position(v));
    }
    if (border.empty() || !(mesh_.diameter() > 0)) return;
    const std::vector<std::int32_t> joins = lowest_within(positions, kNear * mesh_.diameter());
    for (std::size_t i = 0; i < border.size(); ++i) {
      const std::int32_t v = border[i], w = border[index_of(joins[i])];
      const double apart = (mesh_.position(v) - mesh_.position(w)).norm();
      const std::span<const std::int32_t> around = mesh_.neighbours(v);
      if (apart == 0 || std::binary_search(around.begin(), around.end(), w)) continue;
      count_and_name(report_.near_positions, report_.named_near_positions, mesh_.file_vertex(v));
      report_.near_within = std::max(report_.near_within, apart);
    }
  }

  void conclude() {
    for (MeshReport::Component& c : report_.components) {
      c.euler_characteristic = c.vertices - c.edges + c.faces;
      report_.orientable = report_.orientable && c.orientable;
      // Euler and Poincare: chi = 2 - 2 g - b with g handles, 2 - k - b with k cross-caps.
      const std::int32_t missing = 2 - c.boundary_loops - c.euler_characteristic;
      if (c.manifold) c.genus = c.orientable ? missing / 2 : missing;
    }
  }

  const TriangleMesh& mesh_;
  EdgeTable edges_;
  MeshReport report_;
};

}  // namespace

MeshReport inspect(const TriangleMesh& mesh) { return Inspector(mesh).run(); }

}  // namespace leastcost
