// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/exact/landmarks.hpp>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace leastcost {
namespace {

/// The next float that is not above x; of what a float cannot hold, the greatest one it can.
float rounded_down(double x) {
  if (std::isinf(x)) return std::numeric_limits<float>::infinity();
  constexpr float kGreatest = std::numeric_limits<float>::max();
  if (x >= static_cast<double>(kGreatest)) return kGreatest;
  const auto near = static_cast<float>(x);
  return static_cast<double>(near) > x ? std::nextafter(near, -kGreatest) : near;
}

}  // namespace

void Landmarks::add(std::int32_t vertex, std::span<const double> at_least, std::span<const double> at_most) {
  assert(at_least.size() == vertices_ && at_most.size() == vertices_);
  const std::size_t before = vertices_of_.size();
  std::vector<float> wider;
  wider.reserve(vertices_ * (before + 1));
  double width = 0;
  for (std::size_t v = 0; v < vertices_; ++v) {
    const auto row = at_least_.begin() + static_cast<std::ptrdiff_t>(v * before);
    wider.insert(wider.end(), row, row + static_cast<std::ptrdiff_t>(before));
    wider.push_back(rounded_down(at_least[v]));
    if (std::isfinite(at_most[v])) width = std::max(width, at_most[v] - static_cast<double>(wider.back()));
  }
  vertices_of_.push_back(vertex);
  at_least_ = std::move(wider);
  width_.push_back(width * (1 + 8 * std::numeric_limits<double>::epsilon()));
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
