// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/choose_landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <leastcost/problems/mesh/length_search.hpp>

namespace leastcost {

EdgeLandmarks choose_landmarks(const TriangleMesh& mesh, int count, const MetricRoot& metric,
                               const StopPredicate& stop) {
  const std::size_t vertices = static_cast<std::size_t>(mesh.vertex_count());
  const auto& sizes = mesh.component_sizes();
  const auto largest = static_cast<std::int32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  std::int32_t next = 0;
  while (mesh.component(next) != largest) ++next;
  LengthSearch search(mesh);
  LengthSearchOptions options;
  options.metric = metric;
  options.stop = stop;
  std::vector<std::vector<double>> fields;
  std::vector<double> nearest(vertices, std::numeric_limits<double>::infinity());
  // Each lies as far as can be from those before it; the first run only finds a vertex far from any.
  for (int i = -1; i < count; ++i) {
    std::vector<double> field = search.lengths_from(next, options);
    if (stop && stop()) break;
    double farthest = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
      if (std::isinf(field[v])) continue;
      if (i >= 0) nearest[v] = std::min(nearest[v], field[v]);
      const double rank = i < 0 ? field[v] : nearest[v];
      if (rank > farthest) {
        farthest = rank;
        next = static_cast<std::int32_t>(v);
      }
    }
    if (i >= 0) fields.push_back(std::move(field));
    if (!(farthest > 0)) break;
  }
  return EdgeLandmarks(fields);
}

}  // namespace leastcost
