// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>

namespace leastcost {

/// The edges of a triangle list, each with all its halfedges (numbered as in TriangleMesh). Edges ascend by their
/// lower, then their higher vertex number; halfedges of an edge ascend.
struct EdgeTable {
  std::vector<std::array<std::int32_t, 2>> ends;  ///< lower and higher vertex number of each edge
  std::vector<std::int32_t> begin;                ///< edge e owns halfedges [begin[e], begin[e + 1])
  std::vector<std::int32_t> halfedges;

  std::int32_t size() const { return static_cast<std::int32_t>(ends.size()); }
  std::span<const std::int32_t> of(std::int32_t e) const {
    const std::size_t first = static_cast<std::size_t>(begin[static_cast<std::size_t>(e)]);
    const std::size_t last = static_cast<std::size_t>(begin[static_cast<std::size_t>(e) + 1]);
    return std::span<const std::int32_t>(halfedges).subspan(first, last - first);
  }
};

/// Linear time apart from sorting the few edges of each vertex. Throws Interrupted.
EdgeTable make_edge_table(std::span<const std::array<std::int32_t, 3>> faces, std::int32_t vertex_count,
                          const Deadline& deadline = {});

}  // namespace leastcost
