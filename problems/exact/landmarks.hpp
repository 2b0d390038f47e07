// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// Exact distances of all vertices from a few of them, for lower bounds: |d(l, v) - d(l, t)| <= d(v, t). Made for one
/// mesh and its positions, and it knows for which.
class Landmarks {
 public:
  Landmarks() = default;
  /// Of the mesh with this fingerprint.
  explicit Landmarks(std::uint64_t made_for, std::size_t vertices) : made_for_(made_for), vertices_(vertices) {}
  /// As a file has them: the landmarks, their widths, and the distances vertex by vertex.
  Landmarks(std::uint64_t made_for, std::size_t vertices, std::vector<std::int32_t> of, std::vector<double> widths,
            std::vector<float> distances)
      : made_for_(made_for),
        vertices_(vertices),
        vertices_of_(std::move(of)),
        at_least_(std::move(distances)),
        width_(std::move(widths)) {}

  /// One more landmark: each distance lies in [at_least[v], at_most[v]]; infinite where there is no path.
  void add(std::int32_t vertex, std::span<const double> at_least, std::span<const double> at_most);

  std::int32_t count() const { return static_cast<std::int32_t>(vertices_of_.size()); }  ///< number of landmarks
  const std::vector<std::int32_t>& vertices() const { return vertices_of_; }             ///< where they are
  std::uint64_t made_for() const { return made_for_; }                                   ///< fingerprint of the mesh
  /// Length units; of landmark i from vertex v.
  double at_least(std::int32_t v, std::int32_t i) const {
    return static_cast<double>(at_least(v)[static_cast<std::size_t>(i)]);
  }
  /// Upper bound of the distance between vertex v and landmark i.
  double at_most(std::int32_t v, std::int32_t i) const { return at_least(v, i) + width(i); }
  /// Of all landmarks from vertex v.
  std::span<const float> at_least(std::int32_t v) const {
    const std::size_t k = vertices_of_.size();
    return {at_least_.data() + static_cast<std::size_t>(v) * k, k};
  }
  /// No distance from landmark i is greater than its `at_least` by more, length units.
  double width(std::int32_t i) const { return width_[static_cast<std::size_t>(i)]; }
  std::size_t vertex_count() const { return vertices_; }          ///< of the mesh
  std::span<const double> widths() const { return width_; }       ///< of the bounds of each landmark
  std::span<const float> distances() const { return at_least_; }  ///< lower bounds, vertex by vertex

 private:
  std::uint64_t made_for_ = 0;
  std::size_t vertices_ = 0;
  std::vector<std::int32_t> vertices_of_;
  std::vector<float> at_least_;  // vertex by vertex, rounded down
  std::vector<double> width_;    // of each landmark's widest bracket
};

/// A number that differs where positions, faces or their order do (FNV-1a over their bits).
std::uint64_t fingerprint(const TriangleMesh& mesh);

}  // namespace leastcost
