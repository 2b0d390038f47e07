// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/edge_landmarks.hpp"

namespace leastcost {

EdgeLandmarks::EdgeLandmarks(const std::vector<std::vector<double>>& lengths)
    : count_(static_cast<std::int32_t>(lengths.size())) {
  if (lengths.empty()) return;
  const std::size_t vertices = lengths.front().size();
  lengths_.resize(vertices * lengths.size());
  for (std::size_t v = 0, at = 0; v < vertices; ++v)
    for (const std::vector<double>& field : lengths) lengths_[at++] = static_cast<float>(field[v]);
}

}  // namespace leastcost
