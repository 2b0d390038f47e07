// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/exact/forks.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace leastcost {
namespace {

std::pair<std::int32_t, std::int32_t> ends_of(const HalfEdges& mesh, std::int32_t h) {
  return std::minmax({mesh.tail(h), mesh.head(h)});
}

}  // namespace

Forks::Forks(const HalfEdges& mesh) : mesh_(&mesh) {
  for (std::int32_t h = 0; h < 3 * mesh.mesh().face_count(); ++h)
    if (mesh.across(h) == TriangleMesh::kNonManifold) sides_.push_back(h);
  std::stable_sort(sides_.begin(), sides_.end(),
                   [&](std::int32_t g, std::int32_t h) { return ends_of(mesh, g) < ends_of(mesh, h); });
}

std::span<const std::int32_t> Forks::sides(std::int32_t h) const {
  const auto first = std::lower_bound(sides_.begin(), sides_.end(), h, [&](std::int32_t g, std::int32_t sought) {
    return ends_of(*mesh_, g) < ends_of(*mesh_, sought);
  });
  auto last = first;
  while (last != sides_.end() && ends_of(*mesh_, *last) == ends_of(*mesh_, h)) ++last;
  return {std::to_address(first), static_cast<std::size_t>(last - first)};
}

}  // namespace leastcost
