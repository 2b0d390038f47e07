// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/exact/landmarks.hpp>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace leastcost {

void Landmarks::add(std::int32_t vertex, std::span<const double> at_least, std::span<const double> at_most) {
  assert(at_least.size() == vertices_ && at_most.size() == vertices_);
  double width = 0;
  for (std::size_t v = 0; v < vertices_; ++v)
    if (std::isfinite(at_most[v])) width = std::max(width, at_most[v] - at_least[v]);
  vertices_of_.push_back(vertex);
  at_least_.insert(at_least_.end(), at_least.begin(), at_least.end());
  width_.push_back(2 * width);  // and the rounding of the sum
}

std::uint64_t fingerprint(const TriangleMesh& mesh) {
  constexpr std::uint64_t kOffset = 14695981039346656037ULL, kPrime = 1099511628211ULL;
  std::uint64_t hash = kOffset;
  const auto take = [&hash](std::uint64_t word) { hash = (hash ^ word ^ (word >> 32)) * kPrime; };
  for (const Eigen::Vector3d& p : mesh.positions())
    for (int k = 0; k < 3; ++k) take(std::bit_cast<std::uint64_t>(p[k]));
  for (const auto& corners : mesh.faces())
    for (const std::int32_t v : corners) take(static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)));
  return hash;
}

}  // namespace leastcost
