// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "octomap/merge_boxes.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace leastcost {
namespace {

/// Along one axis. Whether some were merged.
bool merge_along(std::size_t axis, std::vector<CellBlock>& blocks) {
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const auto side = [&](const CellBlock& b) { return std::tuple(b.lower[i], b.upper[i], b.lower[j], b.upper[j]); };
  std::sort(blocks.begin(), blocks.end(), [&](const CellBlock& a, const CellBlock& b) {
    return std::pair(side(a), a.lower[axis]) < std::pair(side(b), b.lower[axis]);
  });
  std::vector<CellBlock> out;
  for (const CellBlock& block : blocks) {
    if (!out.empty() && side(out.back()) == side(block) && out.back().upper[axis] == block.lower[axis])
      out.back().upper[axis] = block.upper[axis];
    else
      out.push_back(block);
  }
  const bool some = out.size() < blocks.size();
  blocks.swap(out);
  return some;
}

}  // namespace

std::vector<CellBlock> merged(std::vector<CellBlock> blocks) {
  int without = 0;
  for (std::size_t axis = 0; without < 3; axis = (axis + 1) % 3) without = merge_along(axis, blocks) ? 0 : without + 1;
  return blocks;
}

}  // namespace leastcost
