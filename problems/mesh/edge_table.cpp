// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/edge_table.hpp"

#include <algorithm>
#include <utility>

namespace leastcost {
namespace {

struct Side {
  std::int32_t higher;
  std::int32_t halfedge;
};

std::pair<std::int32_t, std::int32_t> ends_of(std::span<const std::array<std::int32_t, 3>> faces, std::size_t h) {
  const std::int32_t a = faces[h / 3][h % 3];
  const std::int32_t b = faces[h / 3][(h + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

/// Sides in buckets by their lower vertex (a counting sort); `begin` gets the start of each bucket.
std::vector<Side> bucket_sides(std::span<const std::array<std::int32_t, 3>> faces, std::vector<std::size_t>& begin) {
  const std::size_t count = 3 * faces.size();
  for (std::size_t h = 0; h < count; ++h) ++begin[static_cast<std::size_t>(ends_of(faces, h).first) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<std::size_t> fill(begin.begin(), begin.end() - 1);
  std::vector<Side> sides(count);
  for (std::size_t h = 0; h < count; ++h) {
    const auto [lower, higher] = ends_of(faces, h);
    sides[fill[static_cast<std::size_t>(lower)]++] = {higher, static_cast<std::int32_t>(h)};
  }
  return sides;
}

}  // namespace

EdgeTable make_edge_table(std::span<const std::array<std::int32_t, 3>> faces, std::int32_t vertex_count,
                          const Deadline& deadline) {
  std::vector<std::size_t> begin(static_cast<std::size_t>(vertex_count) + 1, 0);
  std::vector<Side> sides = bucket_sides(faces, begin);
  look_at_clock(deadline);
  EdgeTable table;
  table.ends.reserve(sides.size() / 2 + 1);
  table.begin.reserve(sides.size() / 2 + 2);
  table.halfedges.reserve(sides.size());
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    look_at_clock(deadline, static_cast<std::int64_t>(v));
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]), [](const Side& a, const Side& b) {
                return std::pair(a.higher, a.halfedge) < std::pair(b.higher, b.halfedge);
              });
    for (std::size_t i = begin[v]; i < begin[v + 1]; ++i) {
      if (i == begin[v] || sides[i].higher != sides[i - 1].higher) {
        table.begin.push_back(static_cast<std::int32_t>(i));
        table.ends.push_back({static_cast<std::int32_t>(v), sides[i].higher});
      }
      table.halfedges.push_back(sides[i].halfedge);
    }
  }
  table.begin.push_back(static_cast<std::int32_t>(sides.size()));
  return table;
}

}  // namespace leastcost
