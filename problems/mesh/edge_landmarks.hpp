// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace leastcost {

/// Lengths of shortest routes over edges and diagonals from a few vertices far apart, for lower bounds of a search
/// along them: |d(l, v) - d(l, t)| <= d(v, t) (ALT: Goldberg and Harrelson 2005). Immutable, shared by threads.
class EdgeLandmarks {
 public:
  /// Of each landmark the lengths to all vertices.
  explicit EdgeLandmarks(const std::vector<std::vector<double>>& lengths);

  std::int32_t count() const { return count_; }
  /// From all landmarks to vertex v, rounded to float; infinite where there is no route.
  std::span<const float> of(std::int32_t v) const {
    const std::size_t k = static_cast<std::size_t>(count_);
    return {lengths_.data() + static_cast<std::size_t>(v) * k, k};
  }

 private:
  std::int32_t count_ = 0;
  std::vector<float> lengths_;  // vertex by vertex
};

}  // namespace leastcost
