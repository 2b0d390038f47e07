// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
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

  /// One more landmark: each distance lies in [at_least[v], at_most[v]]; infinite where there is no path.
  void add(std::int32_t vertex, std::span<const double> at_least, std::span<const double> at_most);

  std::int32_t count() const { return static_cast<std::int32_t>(vertices_of_.size()); }
  const std::vector<std::int32_t>& vertices() const { return vertices_of_; }
  std::uint64_t made_for() const { return made_for_; }
  /// Length units; of landmark i from vertex v.
  double at_least(std::int32_t v, std::int32_t i) const { return at_least_[place(v, i)]; }
  double at_most(std::int32_t v, std::int32_t i) const { return at_least(v, i) + width_[static_cast<std::size_t>(i)]; }

 private:
  std::size_t place(std::int32_t v, std::int32_t i) const {
    return static_cast<std::size_t>(i) * vertices_ + static_cast<std::size_t>(v);
  }
  std::uint64_t made_for_ = 0;
  std::size_t vertices_ = 0;
  std::vector<std::int32_t> vertices_of_;
  std::vector<double> at_least_;  // landmark by landmark
  std::vector<double> width_;     // of each landmark's widest bracket
};

/// A number that differs where positions, faces or their order do (FNV-1a over their bits).
std::uint64_t fingerprint(const TriangleMesh& mesh);

}  // namespace leastcost
