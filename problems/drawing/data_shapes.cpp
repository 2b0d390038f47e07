// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Data as it is.
#include <algorithm>
#include <string>
#include <utility>

#include "problems/drawing/domain_shapes.hpp"
#include "problems/drawing/thinned.hpp"

namespace leastcost {

TriangleSoup data_surface(TriangleSoup all, const Points& focus, std::vector<std::string>& notes) {
  constexpr std::size_t kMostTriangles = 50000;
  const std::size_t given = all.triangles.size();
  TriangleSoup out = thinned(std::move(all), focus, kMostTriangles);
  if (out.triangles.size() < given)
    notes.push_back("drawn with " + std::to_string(out.triangles.size()) + " triangles instead of " +
                    std::to_string(given) + ", including all near the path");
  return out;
}

Eigen::Vector3d up_of_data(const std::vector<Eigen::Vector3d>& points) {
  if (points.empty()) return Eigen::Vector3d::UnitZ();
  Eigen::Vector3d lower = points.front(), upper = points.front();
  for (const Eigen::Vector3d& x : points) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  const Eigen::Vector3d extent = upper - lower;
  return extent[2] < 0.5 * std::min(extent[0], extent[1]) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
}

}  // namespace leastcost
