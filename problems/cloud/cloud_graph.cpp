// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/cloud_graph.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace leastcost {
namespace {

constexpr double kSteep = 0.5;    ///< sine of 30 degrees out of the tangent plane
constexpr double kHeight = 0.75;  ///< spacings over the tangent plane; curvature alone lifts a neighbour by far less

enum class Edge { good, too_long, too_steep, outlier };

double spacings_between(const PointCloud& cloud, std::int32_t i, std::int32_t j) {
  return 2 * (cloud.sample(j).position - cloud.sample(i).position).norm() / (cloud.spacing(i) + cloud.spacing(j));
}

Edge judge(const PointCloud& cloud, std::int32_t i, std::int32_t j, double max_edge) {
  const CloudSample &a = cloud.sample(i), &b = cloud.sample(j);
  if (!(a.trust > 0 && b.trust > 0)) return Edge::outlier;
  const Eigen::Vector3d e = b.position - a.position;
  const double length = e.norm(), spacing = (cloud.spacing(i) + cloud.spacing(j)) / 2;
  if (length > max_edge * spacing) return Edge::too_long;
  // In a noisy cloud samples lie above each other, as far as the wider supports allow for.
  const double noise = *cloud.settings().radius / PointCloudSettings::kCleanRadius * spacing;
  const double height = std::min(std::abs(a.normal.dot(e)), std::abs(b.normal.dot(e)));
  return height > kSteep * length && height > kHeight * noise ? Edge::too_steep : Edge::good;
}

/// Whether a link lies along the tangent planes of both its ends: stricter than judge(), which knows them as
/// neighbours.
bool along_both(const PointCloud& cloud, std::int32_t i, std::int32_t j) {
  const CloudSample &a = cloud.sample(i), &b = cloud.sample(j);
  const Eigen::Vector3d e = b.position - a.position;
  return std::max(std::abs(a.normal.dot(e)), std::abs(b.normal.dot(e))) <= kSteep * e.norm();
}

/// Links between parts, at most `widest` spacings long: of each sample that is not in the largest part to the nearest
/// one of another.
std::vector<CloudGraph::Gap> links_between_parts(const PointCloud& cloud, const Components& parts, double widest) {
  // A few samples with normals of their own, between two sheets say, must not join them.
  const auto is_crumb = [&](std::int32_t part) {
    return parts.sizes[static_cast<std::size_t>(part)] <= cloud.neighbour_count();
  };
  std::vector<CloudGraph::Gap> links;
  std::vector<Neighbour> found;
  for (std::int32_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t part = parts.of[static_cast<std::size_t>(i)];
    if (part == 0 || is_crumb(part) || !(cloud.sample(i).trust > 0)) continue;
    cloud.search().within(cloud.sample(i).position, widest * cloud.spacing(i), found);
    std::sort(found.begin(), found.end(),
              [](const Neighbour& a, const Neighbour& b) { return a.squared_distance < b.squared_distance; });
    for (const Neighbour& near : found) {
      const std::int32_t there = parts.of[static_cast<std::size_t>(near.index)];
      if (there == part || is_crumb(there)) continue;
      if (!along_both(cloud, i, near.index) || judge(cloud, i, near.index, widest) != Edge::good) continue;
      links.push_back({i, near.index, spacings_between(cloud, i, near.index)});
      break;
    }
  }
  return links;
}

}  // namespace

CloudGraph::CloudGraph(const PointCloud& cloud, const Deadline& deadline) {
  const std::int32_t n = cloud.size();
  std::vector<std::pair<std::int32_t, std::int32_t>> edges;
  edges.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(cloud.neighbour_count()));
  for (std::int32_t i = 0; i < n; ++i) {
    look_at_clock(deadline, i);
    for (int k = 0; k < cloud.neighbour_count(); ++k) {
      const std::int32_t j = cloud.neighbours(i)[k];
      const Edge edge = judge(cloud, i, j, cloud.settings().max_edge);
      if (edge == Edge::too_long) ++long_edges_;
      if (edge == Edge::too_steep) ++steep_edges_;
      if (edge != Edge::good) continue;
      edges.emplace_back(i, j);
      edges.emplace_back(j, i);
    }
  }
  look_at_clock(deadline);
  edges_ = SparseGraph(n, edges);
  look_at_clock(deadline);
  components_ = connected_components(edges_);
  // Whoever raises max_edge wants parts joined; by default what is not among the nearest stays apart.
  if (components_.sizes.size() == 1 || cloud.settings().max_edge <= PointCloudSettings{}.max_edge) return;
  const std::vector<Gap> links = links_between_parts(cloud, components_, cloud.settings().max_edge);
  if (links.empty()) return;
  for (const Gap& link : links) {
    edges.emplace_back(link.from, link.to);
    edges.emplace_back(link.to, link.from);
  }
  edges_ = SparseGraph(n, std::move(edges));
  components_ = connected_components(edges_);
}

std::optional<CloudGraph::Gap> CloudGraph::gap(const PointCloud& cloud, std::int32_t part, std::int32_t other) const {
  std::vector<std::int32_t> root(component_sizes().size());
  const auto find = [&root](std::int32_t i) {
    while (root[static_cast<std::size_t>(i)] != i) i = root[static_cast<std::size_t>(i)];
    return i;
  };
  for (double widest = kWidestGap / 4; widest <= kWidestGap; widest *= 2) {
    std::vector<Gap> links = links_between_parts(cloud, components_, widest);
    std::sort(links.begin(), links.end(), [](const Gap& a, const Gap& b) { return a.spacings < b.spacings; });
    std::iota(root.begin(), root.end(), 0);
    for (const Gap& link : links) {
      root[static_cast<std::size_t>(find(component(link.from)))] = find(component(link.to));
      if (find(part) == find(other)) return link;
    }
  }
  return std::nullopt;
}

std::vector<std::string> CloudGraph::notes() const {
  std::vector<std::string> notes;
  const std::vector<std::int32_t>& parts = component_sizes();
  if (parts.size() > 1) {
    std::string sizes;
    for (std::size_t k = 0; k < std::min<std::size_t>(parts.size(), 5); ++k)
      sizes += (k == 0 ? "" : ", ") + std::to_string(parts[k]);
    notes.push_back("the neighbour graph has " + std::to_string(parts.size()) + " parts with " + sizes +
                    (parts.size() > 5 ? ", ... points" : " points"));
  }
  if (long_edges_ + steep_edges_ > 0)
    notes.push_back("left out of the neighbour graph: " + std::to_string(long_edges_) + " long and " +
                    std::to_string(steep_edges_) + " steep edges (jumps between sheets)");
  return notes;
}

}  // namespace leastcost
