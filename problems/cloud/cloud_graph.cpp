// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/cloud_graph.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

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
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  first_.assign(static_cast<std::size_t>(n) + 1, 0);
  links_.reserve(edges.size());
  for (const auto& [a, b] : edges) {
    ++first_[static_cast<std::size_t>(a) + 1];
    links_.push_back(b);
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  find_components(n);
}

void CloudGraph::find_components(std::int32_t count) {
  component_.assign(static_cast<std::size_t>(count), -1);
  std::vector<std::int32_t> sizes, open;
  for (std::int32_t start = 0; start < count; ++start) {
    if (component(start) >= 0) continue;
    const auto number = static_cast<std::int32_t>(sizes.size());
    sizes.push_back(0);
    open.assign(1, start);
    component_[static_cast<std::size_t>(start)] = number;
    while (!open.empty()) {
      const std::int32_t i = open.back();
      open.pop_back();
      ++sizes.back();
      for (const std::int32_t* j = begin(i); j != end(i); ++j) {
        if (component(*j) >= 0) continue;
        component_[static_cast<std::size_t>(*j)] = number;
        open.push_back(*j);
      }
    }
  }
  std::vector<std::int32_t> order(sizes.size()), rank(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)];
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    rank[static_cast<std::size_t>(order[k])] = static_cast<std::int32_t>(k);
    component_sizes_.push_back(sizes[static_cast<std::size_t>(order[k])]);
  }
  for (std::int32_t& c : component_) c = rank[static_cast<std::size_t>(c)];
}

std::vector<std::string> CloudGraph::notes() const {
  std::vector<std::string> notes;
  if (component_sizes_.size() > 1) {
    std::string sizes;
    for (std::size_t k = 0; k < std::min<std::size_t>(component_sizes_.size(), 5); ++k)
      sizes += (k == 0 ? "" : ", ") + std::to_string(component_sizes_[k]);
    notes.push_back("the neighbour graph has " + std::to_string(component_sizes_.size()) + " parts, of " + sizes +
                    (component_sizes_.size() > 5 ? ", ... points" : " points"));
  }
  if (long_edges_ + steep_edges_ > 0)
    notes.push_back("left out of the neighbour graph: " + std::to_string(long_edges_) + " long and " +
                    std::to_string(steep_edges_) + " steep edges (jumps between sheets)");
  return notes;
}

}  // namespace leastcost
