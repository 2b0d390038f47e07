// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/weld.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace leastcost {

std::vector<std::int32_t> lowest_equal(std::span<const Eigen::Vector3d> positions) {
  struct Entry {
    double x, y, z;
    std::int32_t index;
  };
  std::vector<Entry> entries;
  entries.reserve(positions.size());
  for (const Eigen::Vector3d& p : positions)
    entries.push_back({p.x(), p.y(), p.z(), static_cast<std::int32_t>(entries.size())});
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.x, a.y, a.z, a.index) < std::tie(b.x, b.y, b.z, b.index);
  });
  std::vector<std::int32_t> result(positions.size());
  const Entry* group = nullptr;
  for (const Entry& e : entries) {
    if (!group || std::tie(group->x, group->y, group->z) != std::tie(e.x, e.y, e.z)) group = &e;
    result[static_cast<std::size_t>(e.index)] = group->index;
  }
  return result;
}

}  // namespace leastcost
