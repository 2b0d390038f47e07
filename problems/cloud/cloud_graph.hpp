// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/problems/cloud/point_cloud.hpp>

namespace leastcost {

/// The neighbour graph of a cloud: every sample with its k nearest ones, both ways, without edges that jump. An edge
/// jumps when it is longer than max_edge times the mean spacing of its ends, or when it leaves the tangent planes of
/// both ends by more than 30 degrees and 3/4 of that spacing (the next sheet; more where the cloud is noisy). Outliers
/// have no edges.
class CloudGraph {
 public:
  explicit CloudGraph(const PointCloud& cloud);

  /// Neighbours of sample i.
  const std::int32_t* begin(std::int32_t i) const { return links_.data() + first_[static_cast<std::size_t>(i)]; }
  const std::int32_t* end(std::int32_t i) const { return links_.data() + first_[static_cast<std::size_t>(i) + 1]; }
  std::int32_t component(std::int32_t i) const { return component_[static_cast<std::size_t>(i)]; }
  /// Samples of each connected component, largest first.
  const std::vector<std::int32_t>& component_sizes() const { return component_sizes_; }
  /// Edges left out because they were too long, or too steep.
  std::int32_t long_edges() const { return long_edges_; }
  std::int32_t steep_edges() const { return steep_edges_; }
  /// What a report should say about it.
  std::vector<std::string> notes() const;

 private:
  void find_components(std::int32_t count);

  std::vector<std::size_t> first_;
  std::vector<std::int32_t> links_, component_, component_sizes_;
  std::int32_t long_edges_ = 0, steep_edges_ = 0;
};

}  // namespace leastcost
