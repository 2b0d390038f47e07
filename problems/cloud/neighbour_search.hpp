// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// A point of the set and its squared distance from the query.
struct Neighbour {
  std::int32_t index = -1;      ///< of the sample; -1: none
  double squared_distance = 0;  ///< to the sample
};

/// Nearest points of a fixed set in R^3 (a k-d tree, nanoflann). Queries may run from several threads.
class NeighbourSearch {
 public:
  explicit NeighbourSearch(std::vector<Eigen::Vector3d> points);
  ~NeighbourSearch();
  NeighbourSearch(NeighbourSearch&&) noexcept;
  NeighbourSearch& operator=(NeighbourSearch&&) noexcept;

  const std::vector<Eigen::Vector3d>& points() const;  ///< what is searched
  /// The point nearest to x; the set must not be empty.
  Neighbour nearest(const Eigen::Vector3d& x) const;
  /// The k nearest points (all when there are fewer), nearest first.
  void nearest(const Eigen::Vector3d& x, int k, std::vector<Neighbour>& out) const;
  /// All points closer than `radius`, in no order.
  void within(const Eigen::Vector3d& x, double radius, std::vector<Neighbour>& out) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace leastcost
