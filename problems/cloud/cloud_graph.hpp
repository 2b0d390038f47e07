// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <leastcost/problems/cloud/point_cloud.hpp>
#include <leastcost/problems/graph/sparse_graph.hpp>

namespace leastcost {

/// The neighbour graph of a cloud: every sample with its k nearest ones, both ways, without edges that jump; and where
/// a raised max_edge allows for it, links between the parts that are left, from samples to the nearest of another part.
/// An edge jumps when it is longer than max_edge times the mean spacing of its ends, or when it leaves the tangent
/// planes of both ends by more than 30 degrees and 3/4 of that spacing (the next sheet; more where the cloud is noisy).
/// Outliers have no edges.
class CloudGraph {
 public:
  /// Throws Interrupted.
  explicit CloudGraph(const PointCloud& cloud, const Deadline& deadline = {});

  const SparseGraph& edges() const { return edges_; }  ///< between neighbouring samples
  /// Neighbours of sample i, in ascending order.
  std::span<const std::int32_t> neighbours(std::int32_t i) const { return edges_.successors(i); }
  /// Number of the connected part that a sample is in.
  std::int32_t component(std::int32_t i) const { return components_.of[static_cast<std::size_t>(i)]; }
  /// Samples of each connected component, largest first.
  const std::vector<std::int32_t>& component_sizes() const { return components_.sizes; }
  /// Edges left out because they were too long, or too steep.
  std::int32_t long_edges() const { return long_edges_; }
  /// Number of edges that leave the surface steeply, and were dropped.
  std::int32_t steep_edges() const { return steep_edges_; }
  /// The shortest way without samples that has to be spanned between two parts: the widest of the links that join them.
  struct Gap {
    std::int32_t from = -1, to = -1;  ///< samples on either side
    double spacings = 0;              ///< its width in mean spacings of these; a max_edge as large spans it
  };
  static constexpr double kWidestGap = 24;  ///< in mean spacings: wider links are not looked for
  /// Nothing where no links up to kWidestGap spacings join them.
  std::optional<Gap> gap(const PointCloud& cloud, std::int32_t part, std::int32_t other) const;
  /// What a report should say about it.
  std::vector<std::string> notes() const;

 private:
  SparseGraph edges_;
  Components components_;
  std::int32_t long_edges_ = 0, steep_edges_ = 0;
};

}  // namespace leastcost
