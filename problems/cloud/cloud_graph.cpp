// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/cloud_graph.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace leastcost {
namespace {

constexpr double kSteep = 0.5;    ///< sine of 30 degrees out of the tangent plane
constexpr double kHeight = 0.75;  ///< spacings over the tangent plane; curvature alone lifts a neighbour by far less

enum class Edge { good, too_long, too_steep, outlier };

Edge judge(const PointCloud& cloud, std::int32_t i, std::int32_t j) {
  const CloudSample &a = cloud.sample(i), &b = cloud.sample(j);
  if (!(a.trust > 0 && b.trust > 0)) return Edge::outlier;
  const Eigen::Vector3d e = b.position - a.position;
  const double length = e.norm(), spacing = (cloud.spacing(i) + cloud.spacing(j)) / 2;
  if (length > cloud.settings().max_edge * spacing) return Edge::too_long;
  // In a noisy cloud samples lie above each other, as far as the wider supports allow for.
  const double noise = *cloud.settings().radius / PointCloudSettings::kCleanRadius * spacing;
  const double height = std::min(std::abs(a.normal.dot(e)), std::abs(b.normal.dot(e)));
  return height > kSteep * length && height > kHeight * noise ? Edge::too_steep : Edge::good;
}

}  // namespace

CloudGraph::CloudGraph(const PointCloud& cloud) {
  const std::int32_t n = cloud.size();
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  edges.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(cloud.neighbour_count()));
  for (std::int32_t i = 0; i < n; ++i) {
    for (int k = 0; k < cloud.neighbour_count(); ++k) {
      const std::int32_t j = cloud.neighbours(i)[k];
      const Edge edge = judge(cloud, i, j);
      if (edge == Edge::too_long) ++long_edges_;
      if (edge == Edge::too_steep) ++steep_edges_;
      if (edge != Edge::good) continue;
      edges.emplace_back(i, j);
      edges.emplace_back(j, i);
    }
  }
  edges_ = SparseGraph(n, std::move(edges));
  components_ = connected_components(edges_);
}

std::vector<std::string> CloudGraph::notes() const {
  std::vector<std::string> notes;
  const std::vector<std::int32_t>& parts = component_sizes();
  if (parts.size() > 1) {
    std::string sizes;
    for (std::size_t k = 0; k < std::min<std::size_t>(parts.size(), 5); ++k)
      sizes += (k == 0 ? "" : ", ") + std::to_string(parts[k]);
    notes.push_back("the neighbour graph has " + std::to_string(parts.size()) + " parts, of " + sizes +
                    (parts.size() > 5 ? ", ... points" : " points"));
  }
  if (long_edges_ + steep_edges_ > 0)
    notes.push_back("left out of the neighbour graph: " + std::to_string(long_edges_) + " long and " +
                    std::to_string(steep_edges_) + " steep edges (jumps between sheets)");
  return notes;
}

}  // namespace leastcost
