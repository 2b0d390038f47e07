// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// The surface of a mesh in triangles of its own, known by the lengths of their sides: the vertices stay, edges are
/// flipped. Side k of a face runs from its corner k to its corner k + 1.
class IntrinsicMesh {
 public:
  /// Throws InputError where an edge has three or more faces: what lies across is not defined.
  explicit IntrinsicMesh(const TriangleMesh& mesh);

  /// Flips edges until every one that can be is Delaunay: the opposite angles sum to at most pi. An edge between faces
  /// of opposite orientation stays. Returns the number of flips; ends early when asked to stop.
  std::int64_t make_delaunay(const std::function<bool()>& stop = {});

  std::int32_t face_count() const { return static_cast<std::int32_t>(vertices_.size()); }
  const std::array<std::int32_t, 3>& vertices(std::int32_t f) const { return vertices_[static_cast<std::size_t>(f)]; }
  const std::array<double, 3>& lengths(std::int32_t f) const { return lengths_[static_cast<std::size_t>(f)]; }
  /// Cotangents of the angles opposite to the sides.
  std::array<double, 3> cotangents(std::int32_t f) const;
  double area(std::int32_t f) const;
  double mean_length() const;

 private:
  double cotangent_sum(std::int32_t h) const;
  bool flip(std::int32_t h);
  double& length(std::int32_t h) { return lengths_[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)]; }
  void glue(std::int32_t h, std::int32_t g);

  std::vector<std::array<std::int32_t, 3>> vertices_;
  std::vector<std::array<double, 3>> lengths_;
  std::vector<std::int32_t> across_;
  std::vector<char> turned_;  // per side: what lies across runs in the same direction
};

}  // namespace leastcost
